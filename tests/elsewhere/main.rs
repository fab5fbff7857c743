//! What of the checks runs on any processor: drives and derivatives against independent ones, and the fast ways against the general one.

#[path = "../checks/common.rs"]
#[allow(dead_code, reason = "other checks use the rest of it")]
mod common;
#[path = "../checks/fast_paths.rs"]
mod fast_paths;
#[path = "../checks/oracle.rs"]
mod oracle;
