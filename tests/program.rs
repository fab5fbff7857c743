//! The program that is tested.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// Where it is. `cargo test` builds it before any test runs; it must not be older than what it is made of.
pub fn path() -> &'static Path {
    static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
        // beside the folder of the tests' own programs
        let folder = std::env::current_exe().unwrap().ancestors().nth(2).unwrap().to_owned();
        let program = folder.join(format!("longdrive{}", std::env::consts::EXE_SUFFIX));
        let modified = |path: &Path| fs::metadata(path).and_then(|about| about.modified()).ok();
        let made = modified(&program);
        // cargo lists there what it was made of
        let sources = fs::read_to_string(folder.join("longdrive.d")).unwrap_or_default();
        let newer = sources.split_whitespace().find(|source| modified(source.as_ref()) > made);
        assert!(
            made.is_some() && newer.is_none(),
            "the program is {}: `cargo test --no-run` builds it",
            newer.map_or("missing".into(), |source| format!("older than {source}"))
        );
        program
    });
    &PROGRAM
}

/// It, in the folder of the project.
pub fn command() -> Command {
    let mut program = Command::new(path());
    program.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    program
}
