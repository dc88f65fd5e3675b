//! The reference arithmetic itself.

use f256::f256;

use crate::support::wide::{narrow, power_of_two, wide};

#[test]
fn narrow_undoes_wide() {
    for x in [0.0, 1.0, -1.5, 0.1, 1e-200, -3e200, f64::EPSILON] {
        assert_eq!(narrow(wide(x)), x);
    }
    let third = f256::ONE / wide(3.0);
    assert_eq!(narrow(third), 1.0 / 3.0);
}

#[test]
fn powers_of_two_are_exact() {
    assert_eq!(narrow(power_of_two(0)), 1.0);
    assert_eq!(narrow(power_of_two(-60)), libm::exp2(-60.0));
    assert_eq!(narrow((f256::ONE + power_of_two(-200)) - f256::ONE), libm::exp2(-200.0));
}
