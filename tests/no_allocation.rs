//! No heap memory is used inside a flight, over whatever number it is computed. A program of its own, for it
//! counts every allocation of the process.

use longdrive::flight::fly;
use longdrive::impact::strike;
use longdrive::number::{Jet, Jet2, Number};
use longdrive::{Drive, Setup};

fn allocations<T: Number>(setup: &Setup<f64>, variable: impl Fn(f64) -> T) -> u64 {
    let lifted = setup.map(|row, value| if row.name == "club.loft" { variable(value) } else { T::constant(value) });
    let launch = strike(&lifted).unwrap().launch;
    let counted = allocation_counter::measure(|| {
        fly(&lifted, &launch).unwrap();
        Drive::new(&lifted).unwrap();
    });
    counted.count_total
}

#[test]
fn exact_count_of_allocations_in_a_drive_is_zero() {
    for law in longdrive::parameters::Law::NAMES {
        let mut setup = Setup::default();
        setup.set_law(law).unwrap();
        assert_eq!(allocations(&setup, |value| value), 0);
        assert_eq!(allocations(&setup, |value| Jet::<12>::variable(value, 3)), 0);
        assert_eq!(allocations(&setup, |value| Jet2::<2, 3>::variable(value, 1)), 0);
    }
}
