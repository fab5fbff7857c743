//! The program under test.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// The folder of the project.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Formats that a sweep writes.
pub const FORMATS: &[&str] = if cfg!(feature = "full") {
    &["csv", "jsonl", "parquet"]
} else {
    &["csv", "jsonl"]
};

/// Columns of the terminal of the tests.
const COLUMNS: &str = "100";

/// Path of the program. `cargo test` builds it before any test runs.
pub fn path() -> &'static Path {
    static FOUND: LazyLock<Result<PathBuf, String>> = LazyLock::new(find);
    FOUND
        .as_ref()
        .unwrap_or_else(|why| panic!("the program is {why}: `cargo test --no-run` builds it"))
}

/// A command of the program, in the folder of the project.
pub fn command() -> Command {
    let mut program = Command::new(path());
    program.current_dir(FOLDER).env("COLUMNS", COLUMNS);
    program
}

/// Path of the program. An error if it was not built from the present source with the features of
/// this test.
fn find() -> Result<PathBuf, String> {
    // this test is a program in the folder `deps`, one level below the program under test
    let deps = std::env::current_exe()
        .unwrap()
        .parent()
        .unwrap()
        .to_owned();
    let program = deps
        .parent()
        .unwrap()
        .join(format!("longdrive{}", std::env::consts::EXE_SUFFIX));
    let modified = |path: &Path| fs::metadata(path).and_then(|about| about.modified()).ok();
    let made = modified(&program).ok_or("missing")?;
    // the compiler's lists of the files read for the library and for the program
    let names = fs::read_dir(&deps)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let lists = names.filter(|name| name.starts_with("longdrive-") && name.ends_with(".d"));
    let lists: Vec<_> = lists
        .map(|name| fs::read_to_string(deps.join(name)).unwrap())
        .collect();
    let mut sources = lists
        .iter()
        .flat_map(|list| list.split_whitespace())
        .filter(|word| word.ends_with(".rs"));
    let is_newer =
        |source: &&str| modified(&Path::new(FOLDER).join(source)).is_some_and(|at| at > made);
    if let Some(source) = sources.find(is_newer) {
        return Err(format!("older than {source}"));
    }
    let folder = tempfile::tempdir().unwrap();
    let mut sweep = Command::new(&program);
    sweep
        .args([
            "sweep",
            "--quiet",
            "--over",
            "club.loft=10deg..11deg:2",
            "-o",
        ])
        .arg(folder.path().join("a.parquet"));
    if sweep.output().unwrap().status.success() == FORMATS.contains(&"parquet") {
        Ok(program)
    } else {
        Err("built with other features than the tests".into())
    }
}
