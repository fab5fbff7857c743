//! Files and history of the repository: commit messages, glossary, build profiles.

use crate::imports::{files, source};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("..")
        .canonicalize()
        .unwrap()
}

/// Output of git in the project's folder, `None` without git or without a repository.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git")
        .args(arguments)
        .current_dir(root())
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&output.stdout);
    output.status.success().then(|| text.trim().to_owned())
}

/// Violations of the rules for commit messages in CONTRIBUTING.md.
fn faults(message: &str) -> Vec<String> {
    let (subject, rest) = message.split_once('\n').unwrap_or((message, ""));
    let length = subject.chars().count();
    let mut faults = vec![];
    if length > 72 {
        faults.push(format!(
            "a subject of {length} characters, more than 72: {subject}"
        ));
    }
    if !rest.is_empty() && !rest.starts_with('\n') {
        faults.push(format!("no empty line after the subject: {subject}"));
    }
    if rest.trim().is_empty() {
        faults.push(format!("no body that says why: {subject}"));
    }
    faults
}

#[test]
fn faults_of_commit_messages_are_found() {
    let subject = "a".repeat(72);
    assert!(faults(&format!("{subject}\n\nReason.")).is_empty());
    assert_eq!(faults(&format!("{subject}b\n\nReason.")).len(), 1);
    assert_eq!(faults("Subject\nReason.").len(), 1);
    assert_eq!(faults("Subject").len(), 1);
    assert_eq!(faults("Subject\n\n").len(), 1);
}

/// Reads the commits after the commit that added this file.
#[test]
fn newest_commits_have_a_short_subject_and_a_body() {
    // a source archive may be unpacked inside another repository
    let is_this_repository = git(&["rev-parse", "--show-toplevel"])
        .is_some_and(|folder| Path::new(&folder).canonicalize().ok() == Some(root()));
    let added = [
        "log",
        "--no-renames",
        "--diff-filter=A",
        "--format=%H",
        "--",
        "tests/checks/repository.rs",
    ];
    // in a shallow clone the oldest commit counts as the commit that added this file
    let Some(first) = git(&added)
        .filter(|_| is_this_repository)
        .and_then(|hashes| hashes.lines().next().map(str::to_owned))
    else {
        return;
    };
    let later = format!("{first}..HEAD");
    let messages = git(&["log", "--no-merges", "--format=%B%x00", &later]).unwrap_or_default();
    let faults: Vec<String> = messages
        .split('\0')
        .map(str::trim_start)
        .filter(|message| !message.is_empty())
        .flat_map(faults)
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Names that may be declared twice: `Args` of each command, and `Status` in `batch` and
/// `optimize`.
const SHARED_NAMES: [&str; 2] = ["Args", "Status"];

/// The types that the code declares at its top level.
fn declared_types(code: &str) -> impl Iterator<Item = &str> {
    code.lines().filter_map(|line| {
        let item = match line.strip_prefix("pub(") {
            Some(rest) => rest.split_once(") ")?.1,
            None => line.strip_prefix("pub ").unwrap_or(line),
        };
        let (kind, rest) = item.split_once(' ')?;
        let is_type = ["struct", "enum", "trait", "type"].contains(&kind);
        let name = rest.split(|c: char| !c.is_alphanumeric()).next()?;
        is_type.then_some(name)
    })
}

#[test]
fn declared_types_are_found() {
    let code =
        "pub struct A<T>(T);\npub(in crate::f) enum B {\ntype C = u8;\n    struct D;\nfn e() {\n";
    assert!(declared_types(code).eq(["A", "B", "C"]));
}

#[test]
fn types_have_names_of_their_own() {
    let mut places: BTreeMap<String, Vec<PathBuf>> = BTreeMap::new();
    for file in files(source()) {
        if file.extension().is_none_or(|ending| ending != "rs") {
            continue;
        }
        let code = std::fs::read_to_string(&file).unwrap();
        for name in declared_types(&code) {
            places.entry(name.into()).or_default().push(file.clone());
        }
    }
    assert!(places.len() > 500, "{} types", places.len());
    places.retain(|name, files| files.len() > 1 && !SHARED_NAMES.contains(&name.as_str()));
    assert!(places.is_empty(), "rename all but one: {places:#?}");
}

/// The glossary of CONTRIBUTING.md is short, and its names exist in the code.
#[test]
fn names_of_the_glossary_exist() {
    let text = std::fs::read_to_string(root().join("CONTRIBUTING.md")).unwrap();
    let (_, glossary) = text.split_once("\n## Glossary\n").unwrap();
    let (glossary, _) = glossary.split_once("\n## ").unwrap();
    let rows: Vec<Vec<&str>> = glossary
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| term "))
        .map(|line| line.trim_matches('|').split(" | ").map(str::trim).collect())
        .collect();
    assert!((40..=60).contains(&rows.len()), "{} terms", rows.len());

    let code: String = files(source())
        .iter()
        .filter(|file| file.extension().is_some_and(|ending| ending == "rs"))
        .map(|file| std::fs::read_to_string(file).unwrap())
        .collect();
    let is_declared = |declaration: String| {
        code.match_indices(&declaration).any(|(at, _)| {
            let next = code[at + declaration.len()..].chars().next();
            next.is_some_and(|c| !c.is_alphanumeric() && c != '_')
        })
    };
    let is_item = |name: &str| {
        let kinds = ["struct", "enum", "trait", "type", "fn", "mod"];
        kinds
            .iter()
            .any(|kind| is_declared(format!("{kind} {name}")))
    };
    for row in rows {
        let [term, meaning, names] = row[..] else {
            panic!("not three cells: {row:?}")
        };
        assert!(!meaning.is_empty(), "{term} has no meaning");
        for name in names.split('`').skip(1).step_by(2) {
            let exists = if name.starts_with("src/") {
                root().join(name).exists()
            } else if name.contains("::") {
                name.split("::").all(is_item)
            } else {
                let name = name.trim_end_matches('*');
                let command = name.strip_prefix("longdrive ").unwrap_or(name);
                code.contains(&format!("\"{command}"))
            };
            assert!(exists, "{term}: the code has no `{name}`");
        }
    }
}

/// The program aborts on a panic, but the Python package must raise an exception, which needs an
/// unwinding panic.
#[test]
fn a_wheel_of_the_python_package_unwinds() {
    /// Lines of a section of a TOML file.
    fn section(path: &str, head: &str) -> Vec<String> {
        let text = std::fs::read_to_string(root().join(path)).unwrap();
        text.lines()
            .skip_while(|line| *line != head)
            .skip(1)
            .take_while(|line| !line.starts_with('['))
            .map(str::to_owned)
            .collect()
    }
    let wheel = r#"profile = "wheel""#.to_owned();
    let unwinds = r#"panic = "unwind""#.to_owned();
    assert!(section("python/pyproject.toml", "[tool.maturin]").contains(&wheel));
    assert!(section("Cargo.toml", "[profile.wheel]").contains(&unwinds));
}
