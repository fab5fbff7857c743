//! The collision by Winfield & Tan's 15 equations in 15 unknowns. It verifies the three equations
//! of the library.

use longdrive::impact::{Collision, Rebound};
use longdrive::number::{Number, Vector};

/// Solves the collision from 12 equations of momentum (Winfield & Tan 1994, eq. 15), restitution
/// (18) and no slip (19, 20). The unknowns are 12 generalized speeds and the 3 components of the
/// impulse R on the club. A hundred times slower than [`Collision::by_impulse`].
pub fn by_generalized_speeds<T: Number>(collision: &Collision<T>) -> Rebound<T> {
    let mut system = SpeedSystem {
        a: [[T::zero(); 15]; 15],
        b: [T::zero(); 15],
    };
    let [first, second] = tangents(collision.normal);
    let directions = [collision.normal, first, second];
    system.add_momentum(collision);
    system.add_separation(collision, &directions);
    system.add_gear_scale(collision, &directions);
    let u = solve(system.a, system.b).expect("the 15 × 15 system has a solution");
    let vector = |at: usize| Vector::new(u[at], u[at + 1], u[at + 2]);
    Rebound {
        impulse: -vector(IMPULSE),
        ball_velocity: vector(BALL_VELOCITY),
        ball_spin: vector(BALL_SPIN),
        club_velocity: vector(CLUB_VELOCITY),
        club_spin: vector(CLUB_SPIN),
    }
}

/// Two perpendicular unit tangents of the face at a contact point with the normal n.
fn tangents<T: Number>(n: Vector<T>) -> [Vector<T>; 2] {
    // a direction perpendicular to the normal and to Y, or to the normal and to X if the normal is
    // nearly along Y
    let across = if n.y.re().abs() < 0.9 {
        Vector::new(n.z, T::zero(), -n.x)
    } else {
        Vector::new(T::zero(), n.z, -n.y)
    };
    let first = across * across.norm().recip();
    [first, n.cross(first)]
}

// index of the first row or column of each block of the 15 × 15 system
const CLUB_VELOCITY: usize = 0;
const CLUB_SPIN: usize = 3;
const BALL_VELOCITY: usize = 6;
const BALL_SPIN: usize = 9;
const IMPULSE: usize = 12;
const CONTACT: usize = 12;

/// Winfield & Tan's 15 equations A u = b.
struct SpeedSystem<T> {
    a: [[T; 15]; 15],
    b: [T; 15],
}

impl<T: Number> SpeedSystem<T> {
    /// Adds the equations of momentum and angular momentum of both bodies (eq. 6): ΔP = ±R, ΔL = r
    /// × (±R).
    fn add_momentum(&mut self, collision: &Collision<T>) {
        let Self { a, b } = self;
        let axes: [Vector<T>; 3] = std::array::from_fn(|k| {
            Vector::from_array(std::array::from_fn(|i| {
                T::constant(f64::from(u8::from(i == k)))
            }))
        });
        let to_ball_surface = -collision.normal * collision.ball_radius;
        let velocity = collision.club_velocity.to_array();
        let spin = collision.club_spin.to_array();
        for i in 0..3 {
            a[CLUB_VELOCITY + i][CLUB_VELOCITY + i] = collision.club_mass;
            a[CLUB_VELOCITY + i][IMPULSE + i] = T::constant(-1.0);
            b[CLUB_VELOCITY + i] = collision.club_mass * velocity[i];
            a[BALL_VELOCITY + i][BALL_VELOCITY + i] = collision.ball_mass;
            a[BALL_VELOCITY + i][IMPULSE + i] = T::constant(1.0);
            a[BALL_SPIN + i][BALL_SPIN + i] = collision.ball_inertia;
            for (k, axis) in axes.into_iter().enumerate() {
                let inertia = collision.club_inertia[i][k];
                a[CLUB_SPIN + i][CLUB_SPIN + k] = inertia;
                b[CLUB_SPIN + i] = b[CLUB_SPIN + i] + inertia * spin[k];
                a[CLUB_SPIN + i][IMPULSE + k] = -collision.contact.cross(axis).to_array()[i];
                a[BALL_SPIN + i][IMPULSE + k] = to_ball_surface.cross(axis).to_array()[i];
            }
        }
    }

    /// Adds the equations of restitution along the normal and the tangents (eq. 7): the separation
    /// velocity is −(coefficient of restitution) × (approach velocity).
    fn add_separation(&mut self, collision: &Collision<T>, directions: &[Vector<T>; 3]) {
        let Self { a, b } = self;
        let approach = collision.approach();
        let to_ball_surface = -collision.normal * collision.ball_radius;
        let coefficients = [
            collision.restitution,
            collision.tangential_restitution,
            collision.tangential_restitution,
        ];
        for (row, (direction, coefficient)) in directions.iter().zip(coefficients).enumerate() {
            let along = direction.to_array();
            let club_arm = collision.contact.cross(*direction).to_array();
            let ball_arm = to_ball_surface.cross(*direction).to_array();
            for i in 0..3 {
                a[CONTACT + row][CLUB_VELOCITY + i] = along[i];
                a[CONTACT + row][CLUB_SPIN + i] = club_arm[i];
                a[CONTACT + row][BALL_VELOCITY + i] = -along[i];
                a[CONTACT + row][BALL_SPIN + i] = -ball_arm[i];
            }
            b[CONTACT + row] = -coefficient * approach.dot(*direction);
        }
    }

    /// Applies the scale g of the gear effect (eq. 9a): adds (g − 1) times the velocities along the
    /// face that the rotation of the head causes.
    fn add_gear_scale(&mut self, collision: &Collision<T>, directions: &[Vector<T>; 3]) {
        let Some(scale) = collision.gear_scale else {
            return;
        };
        let rigid = Collision {
            gear_scale: None,
            ..*collision
        };
        let n = collision.normal;
        // K n, with the compliance K of rigid bodies, and w = K n − (n·K n) n
        let [x, y, z] = rigid.compliance().expect("a positive definite K");
        let pushed = x * n.x + y * n.y + z * n.z;
        let w = pushed - n * n.dot(pushed);
        for (row, direction) in directions.iter().enumerate() {
            let more = n * direction.dot(w) + w * direction.dot(n);
            for (entry, part) in self.a[CONTACT + row][IMPULSE..]
                .iter_mut()
                .zip(more.to_array())
            {
                *entry = *entry + part * (scale - 1.0);
            }
        }
    }
}

/// Solves A x = b by Gaussian elimination with partial pivoting. `None` if A is exactly singular or
/// has an entry that is not finite.
fn solve<T: Number, const N: usize>(mut a: [[T; N]; N], mut b: [T; N]) -> Option<[T; N]> {
    for column in 0..N {
        let pivot = (column..N).max_by(|&i, &j| {
            let size = |row: usize| a[row][column].re().abs();
            size(i).total_cmp(&size(j))
        })?;
        let size = a[pivot][column].re();
        if size == 0.0 || !size.is_finite() {
            return None;
        }
        a.swap(column, pivot);
        b.swap(column, pivot);
        let inverse = a[column][column].recip();
        for row in column + 1..N {
            let factor = a[row][column] * inverse;
            let (above, below) = a.split_at_mut(row);
            for (entry, eliminated) in below[0].iter_mut().zip(above[column]).skip(column + 1) {
                *entry = *entry - factor * eliminated;
            }
            b[row] = b[row] - factor * b[column];
        }
    }
    for row in (0..N).rev() {
        for k in row + 1..N {
            b[row] = b[row] - a[row][k] * b[k];
        }
        b[row] = b[row] / a[row][row];
    }
    Some(b)
}

#[test]
fn exact_system_that_needs_a_pivot() {
    let x = solve([[0.0, 2.0], [4.0, 2.0]], [2.0, 6.0]);
    assert_eq!(x, Some([1.0, 1.0]));
}
