//! Imports between files of the library: no circle.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

/// The folder of the library.
pub fn source() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("..")
        .join("src")
}

/// The path itself if it is a file, else all files below it.
pub fn files(place: PathBuf) -> Vec<PathBuf> {
    if place.is_file() {
        return vec![place];
    }
    std::fs::read_dir(place)
        .unwrap()
        .flat_map(|entry| files(entry.unwrap().path()))
        .collect()
}

/// The paths of a tree such as `a::{b, c::{d, e}}`.
fn paths(tree: &str) -> Vec<String> {
    let Some((stem, rest)) = tree.split_once('{') else {
        return vec![tree.trim().into()];
    };
    let mut depth = 0;
    let parts = rest.rsplit_once('}').unwrap().0.split(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    parts
        .filter(|part| !part.trim().is_empty())
        .flat_map(paths)
        .map(|path| format!("{stem}{path}"))
        .collect()
}

/// A path of a `use` line.
struct Use {
    is_reexport: bool,
    path: String,
    /// The name by which the file uses it.
    name: String,
}

struct Names {
    uses: Vec<Use>,
    /// The paths outside of `use` lines, such as `super::map::capital`.
    paths: Vec<String>,
}

impl Names {
    /// Names in a text, without comments and unit tests. The `$crate` of a macro counts for the
    /// file that calls the macro.
    fn of(text: &str) -> Self {
        let text = text.split("\n#[cfg(test)]\nmod tests {").next().unwrap();
        let is_use = |line: &&str| {
            line.starts_with("use ") || (line.starts_with("pub") && line.contains(" use "))
        };
        let trees = text.split(';').filter_map(|piece| {
            let lines: String = piece.lines().skip_while(|line| !is_use(line)).collect();
            lines
                .split_once("use ")
                .map(|(visibility, tree)| (!visibility.is_empty(), paths(tree)))
        });
        let uses = trees.flat_map(|(is_reexport, paths)| {
            paths.into_iter().map(move |path| {
                let (path, alias) = path.split_once(" as ").unwrap_or((&path, ""));
                let name = if alias.is_empty() {
                    path.rsplit("::").next().unwrap()
                } else {
                    alias
                };
                Use {
                    is_reexport,
                    path: path.into(),
                    name: name.into(),
                }
            })
        });
        let code = text
            .lines()
            .filter(|line| !is_use(line) && !line.trim().starts_with("//"));
        // visibility within a module is no import
        let code = code.map(|line| {
            line.split_once("pub(in ")
                .and_then(|(_, rest)| rest.split_once(')'))
                .map_or(line, |(_, rest)| rest)
        });
        let words =
            code.flat_map(|line| line.split(|c: char| !(c.is_alphanumeric() || "_:$".contains(c))));
        let paths = words
            .filter(|word| word.contains("::"))
            .map(|word| word.trim_end_matches(':').to_owned());
        Self {
            uses: uses.collect(),
            paths: paths.collect(),
        }
    }
}

/// The module whose file defines the target of a path.
fn defined(files: &BTreeMap<String, Names>, module: &str, path: &str) -> String {
    let (name, rest) = path.split_once("::").unwrap_or((path, ""));
    let next = match name {
        "super" => module.rsplit_once("::").unwrap().0.to_owned(),
        "crate" => "src".to_owned(),
        name => format!("{module}::{name}"),
    };
    if files.contains_key(&next) {
        return defined(files, &next, rest);
    }
    // skip a re-export of the path itself: this file defines the macro that it re-exports, so the
    // path leads to no other file
    let reexport = files[module]
        .uses
        .iter()
        .find(|of| of.is_reexport && of.name == name && of.path != path);
    reexport.map_or(module.to_owned(), |of| defined(files, module, &of.path))
}

/// Imports of each file.
type Imports = BTreeMap<String, BTreeSet<String>>;

/// The imports of each file of the library, with files named as modules: `use` lines, and paths in
/// the code. Re-exports are no imports.
fn imports() -> Imports {
    let source = source();
    let text = |path: &PathBuf| std::fs::read_to_string(path).unwrap();
    let module = |path: &PathBuf| {
        let module = path
            .with_extension("")
            .to_str()
            .unwrap()
            .replace(source.to_str().unwrap(), "src")
            .replace(['/', '\\'], "::");
        ["::mod", "::lib"]
            .iter()
            .fold(&module[..], |module, end| module.trim_end_matches(end))
            .to_owned()
    };
    let files: BTreeMap<_, _> = files(source.clone())
        .iter()
        .map(|path| (module(path), Names::of(&text(path))))
        .collect();
    let of = |(module, names): (&String, &Names)| {
        let used = names
            .uses
            .iter()
            .filter(|of| !of.is_reexport)
            .map(|of| &of.path);
        let begins = |path: &&String| {
            let first = path.split("::").next().unwrap();
            ["super", "crate"].contains(&first) || files.contains_key(&format!("{module}::{first}"))
        };
        let all = used
            .chain(names.paths.iter().filter(begins))
            .map(|path| defined(&files, module, path));
        (
            module.clone(),
            all.filter(|other| other != module).collect(),
        )
    };
    files.iter().map(of).collect()
}

/// Finds a circle: each file imports the next, and the last file imports the first.
fn circle(mut imports: Imports) -> Option<Vec<String>> {
    // remove files that import no remaining file, because they are in no circle, until none is left
    loop {
        let is_end =
            |others: &BTreeSet<String>| others.iter().all(|other| !imports.contains_key(other));
        let ends: Vec<_> = imports
            .iter()
            .filter(|(_, others)| is_end(others))
            .map(|(one, _)| one.clone())
            .collect();
        if ends.is_empty() {
            break;
        }
        imports.retain(|one, _| !ends.contains(one));
    }
    // every remaining file imports another remaining file: a walk along imports returns to a file
    let mut way = vec![imports.keys().next()?.clone()];
    loop {
        let next = imports[way.last()?]
            .iter()
            .find(|other| imports.contains_key(*other))?;
        if let Some(first) = way.iter().position(|one| one == next) {
            return Some(way.split_off(first));
        }
        way.push(next.clone());
    }
}

#[test]
fn no_circle_of_imports_between_files() {
    let imports = imports();
    let count: usize = imports.values().map(BTreeSet::len).sum();
    assert!(count > 2500, "{count} imports");
    assert_eq!(circle(imports), None);
}

#[test]
fn no_circle_of_imports_between_modules() {
    let module = |file: &String| file.split("::").nth(1).map(str::to_owned);
    let mut modules = Imports::new();
    for (file, others) in imports() {
        let Some(own) = module(&file) else { continue };
        let others = others
            .iter()
            .filter_map(module)
            .filter(|other| *other != own);
        modules.entry(own.clone()).or_default().extend(others);
    }
    let count: usize = modules.values().map(BTreeSet::len).sum();
    assert!(
        modules.len() > 20 && count > 100,
        "{count} imports of {} modules",
        modules.len()
    );
    assert_eq!(circle(modules), None);
}

#[test]
fn a_circle_of_any_length_is_found() {
    let of = |pairs: &[(&str, &str)]| {
        let mut imports = Imports::new();
        for (one, other) in pairs {
            imports
                .entry((*one).into())
                .or_default()
                .insert((*other).into());
            imports.entry((*other).into()).or_default();
        }
        circle(imports)
    };
    assert_eq!(of(&[("a", "b"), ("a", "c"), ("b", "c"), ("c", "d")]), None);
    let found = of(&[
        ("a", "b"),
        ("b", "c"),
        ("b", "f"),
        ("c", "d"),
        ("d", "b"),
        ("d", "e"),
    ]);
    assert_eq!(found.unwrap(), ["b", "c", "d"]);
    assert_eq!(of(&[("a", "b"), ("b", "a")]).unwrap(), ["a", "b"]);
}

/// Each number type of the core is compiled again for each instruction set, so the types must be in
/// one list.
#[test]
fn the_core_is_compiled_for_the_numbers_of_one_list() {
    let list = std::fs::read_to_string(source().join("number/compiled.rs")).unwrap();
    let largest = "const MOST_PER_LANE: usize = ";
    let largest = list.split(largest).nth(1).unwrap().split(';').next();
    let list = list.replace("MOST_PER_LANE, ", &format!("{}, ", largest.unwrap()));
    let numbers: BTreeSet<&str> = list
        .split("work.over::<")
        .skip(1)
        .map(|rest| rest.split(">(").next().unwrap())
        .collect();

    let text = std::fs::read_to_string(source().join("../docs/architecture.md")).unwrap();
    let documented: BTreeSet<&str> = text
        .split("| number | holds |")
        .nth(1)
        .unwrap()
        .lines()
        .skip(2)
        .map_while(|line| line.strip_prefix("| `")?.split('`').next())
        .collect();
    assert_eq!(numbers, documented, "src/number/compiled.rs and its table");

    let others = files(source()).into_iter().filter(|file| {
        let name = file.strip_prefix(source()).unwrap();
        !name.starts_with("number") && name.extension().is_some_and(|ending| ending == "rs")
    });
    let mut with_num_dual = vec![];
    for file in others {
        let text = std::fs::read_to_string(&file).unwrap();
        let code = text.split("\n#[cfg(test)]\nmod tests {").next().unwrap();
        let has = |name: &str| {
            code.lines()
                .any(|line| !line.trim_start().starts_with("//") && line.contains(name))
        };
        let name = file.strip_prefix(source()).unwrap().to_str().unwrap();
        assert!(
            !has("Jet<") && !has("Mixed<"),
            "{name} names a number of the core: add it to src/number/compiled.rs"
        );
        if has("constant::<Dual64>") {
            with_num_dual.push(name.replace('\\', "/"));
        }
    }
    assert_eq!(with_num_dual, ["study/certificate/agreement.rs"]);
}
