//! What the program weighs, and what its files import.

use crate::program;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

/// A flight loop is compiled for each number that drives are made of: it is most of what the library costs to build. Its copies are
/// counted among the names of functions in the program, which say for what numbers they are (`.cargo/config.toml`).
#[test]
#[cfg(target_os = "linux")]
fn regress_copies_of_the_flight_loop_at_most_twenty() {
    let program = std::fs::read(program::path()).unwrap();
    let is_flight = |name: &&[u8]| {
        let has = |part: &str| name.windows(part.len()).any(|window| window == part.as_bytes());
        name.starts_with(b"_R") && has("8outlined") && has("5Ended") && has("6follow")
    };
    let copies: std::collections::HashSet<&[u8]> = program.split(|byte| *byte == 0).filter(is_flight).collect();
    assert!((3..=20).contains(&copies.len()), "{} copies of the flight loop", copies.len());
}

/// A release of the program does not unwind, but a panic in a wheel of the Python package must become an exception.
#[test]
fn a_wheel_of_the_python_package_unwinds() {
    // the lines below a head, up to the next one
    let table = |path: &str, head: &str| -> Vec<String> {
        let text = std::fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).unwrap();
        let lines = text.lines().skip_while(|line| *line != head).skip(1);
        lines.take_while(|line| !line.starts_with('[')).map(str::to_owned).collect()
    };
    assert!(table("python/pyproject.toml", "[tool.maturin]").contains(&r#"profile = "wheel""#.into()));
    assert!(table("Cargo.toml", "[profile.wheel]").contains(&r#"panic = "unwind""#.into()));
}

/// The paths of a tree such as `a::{b, c::{d, e}}`.
fn paths(tree: &str) -> Vec<String> {
    let Some((stem, rest)) = tree.split_once('{') else { return vec![tree.trim().into()] };
    let mut depth = 0;
    let parts = rest.rsplit_once('}').unwrap().0.split(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    parts.flat_map(paths).map(|path| format!("{stem}{path}")).collect()
}

/// The module in whose file stands what a path in a module leads to.
fn defined(uses: &BTreeMap<String, Vec<(bool, String)>>, module: &str, path: &str) -> String {
    let (name, rest) = path.split_once("::").unwrap_or((path, ""));
    let next = match name {
        "super" => module.rsplit_once("::").unwrap().0.to_owned(),
        "crate" => "src".to_owned(),
        name => format!("{module}::{name}"),
    };
    if uses.contains_key(&next) {
        return defined(uses, &next, rest);
    }
    let handed_on = uses[module].iter().find(|(is_public, path)| *is_public && path.ends_with(&format!("::{name}")));
    handed_on.map_or(module.to_owned(), |(_, path)| defined(uses, module, path))
}

#[test]
fn regress_no_two_files_import_from_each_other() {
    let (mut uses, mut imports, source) =
        (BTreeMap::new(), BTreeSet::new(), format!("{}/../src", env!("CARGO_MANIFEST_DIR")));
    let mut left = vec![PathBuf::from(&source)];
    while let Some(path) = left.pop() {
        if path.is_dir() {
            left.extend(std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()));
            continue;
        }
        let module = path.with_extension("").to_str().unwrap().replace(&source, "src").replace(['/', '\\'], "::");
        let module = ["::mod", "::lib", "::main"].iter().fold(&module[..], |module, end| module.trim_end_matches(end));
        let text = std::fs::read_to_string(&path).unwrap();
        // what stands in functions and tests is indented
        let lines = text.split(';').filter_map(|piece| piece.rsplit_once("use "));
        let lines = lines.map(|(before, tree)| (before.rsplit('\n').next().unwrap(), tree));
        let lines = lines.filter(|(visibility, _)| visibility.is_empty() || visibility.starts_with("pub"));
        let of =
            lines.flat_map(|(visibility, tree)| paths(tree).into_iter().map(|path| (!visibility.is_empty(), path)));
        uses.insert(module.to_owned(), of.collect::<Vec<_>>());
        // a folder's own files are also named where they are used
        let code = text.lines().filter(|line| !line.contains("use ") && !line.trim().starts_with("//"));
        let words = code.flat_map(|line| line.split(|c: char| !(c.is_alphanumeric() || "_:".contains(c))));
        let named = words.filter_map(|word| Some(format!("{module}::{}", word.split_once("::")?.0)));
        imports.extend(named.map(|other| (module.to_owned(), other)));
    }
    imports.retain(|(_, other)| uses.contains_key(other));
    for (module, paths) in &uses {
        let own = paths.iter().filter(|(is_public, _)| !is_public);
        imports.extend(own.map(|(_, path)| (module.clone(), defined(&uses, module, path))).filter(|(a, b)| a != b));
    }
    assert!(imports.len() > 500, "{} imports", imports.len());
    let circles: Vec<_> = imports.iter().filter(|(a, b)| a < b && imports.contains(&(b.clone(), a.clone()))).collect();
    assert!(circles.is_empty(), "{circles:?}");
}
