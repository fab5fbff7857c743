//! One drive: setup, impact, flight and trajectory.
//!
//! `cargo run --release --example drive`

use longdrive::flight::trajectory;
use longdrive::{Drive, Outcome, Setup};

fn main() -> longdrive::Result<()> {
    let mut setup = Setup::preset("modern-driver")?;
    setup.set("swing.attack_angle", "4 deg")?;
    setup.set("strike.toe", "10 mm")?; // off-centre: gear effect
    setup.set("wind.downrange", "-3 m/s")?;

    let drive = Drive::new(&setup)?;
    for outcome in [
        Outcome::BallSpeed,
        Outcome::LaunchAngle,
        Outcome::Backspin,
        Outcome::Sidespin,
        Outcome::Carry,
        Outcome::Lateral,
    ] {
        println!(
            "{:>14}  {}",
            outcome.name(),
            outcome.show(outcome.of(&drive)?)
        );
    }

    println!("\n  time s   downrange m   right m   up m");
    let path = trajectory(&setup, &drive.launch)?;
    for point in path.points.iter().step_by(100).chain(path.points.last()) {
        let at = point.position;
        println!("{:8.2} {:13.2} {:9.2} {:6.2}", point.time, at.z, at.y, at.x);
    }
    Ok(())
}
