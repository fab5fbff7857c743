//! The checks that run on any processor: drives and derivatives beside independent ones, and drives
//! in vector registers beside drives alone. CONTRIBUTING.md says how to run them for another
//! processor.

#[path = "../checks/common.rs"]
#[allow(dead_code, reason = "other checks use the rest of it")]
mod common;
#[path = "../checks/fast_paths.rs"]
mod fast_paths;
#[path = "../checks/oracle.rs"]
mod oracle;
