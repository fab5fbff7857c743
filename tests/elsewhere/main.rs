//! Checks that run on any processor: drives and derivatives compared with an independent
//! computation, and drives in vector registers compared with scalar ones. CONTRIBUTING.md says how
//! to run them for another processor.

#[path = "../checks/common.rs"]
#[expect(dead_code, reason = "other checks use the rest of it")]
mod common;
#[path = "../checks/fast_paths.rs"]
mod fast_paths;
#[path = "../checks/oracle.rs"]
mod oracle;
