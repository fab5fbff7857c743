//! The program that is tested.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// Where it is. `cargo test` builds it before any test runs.
pub fn path() -> &'static Path {
    static FOUND: LazyLock<Result<PathBuf, String>> = LazyLock::new(find);
    FOUND.as_ref().unwrap_or_else(|why| panic!("the program is {why}: `cargo test --no-run` builds it"))
}

/// It, in the folder of the project.
pub fn command() -> Command {
    let mut program = Command::new(path());
    program.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    program
}

/// It, where it is not older than what it was made of; else what is wrong with it.
fn find() -> Result<PathBuf, String> {
    // beside the folder of the tests' own programs
    let folder = std::env::current_exe().unwrap().ancestors().nth(2).unwrap().to_owned();
    let program = folder.join(format!("longdrive{}", std::env::consts::EXE_SUFFIX));
    let modified = |path: &Path| fs::metadata(path).and_then(|about| about.modified()).ok();
    let made = modified(&program).ok_or("missing")?;
    // cargo lists there what it was made of
    let sources = fs::read_to_string(folder.join("longdrive.d")).unwrap_or_default();
    let newer = sources.split_whitespace().find(|source| modified(source.as_ref()).is_some_and(|at| at > made));
    newer.map_or(Ok(program), |source| Err(format!("older than {source}")))
}
