//! Runs a question in a folder of its own, and lists the faults of the answer.

use crate::program;
use crate::questions::Question;
use crate::schema::faults;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// Time limit of a question, s, on a slow machine with other work.
const LONGEST: Duration = Duration::from_secs(120);

/// Endings of the files that the program writes beside a named output.
const COMPANIONS: [&str; 2] = [".part", ".resume"];

/// Values of `status` in JSON for the exit status 0.
const FOUND: [&str; 4] = ["done", "landed", "converged", "passed"];

/// Runs a question: exit status and faults of the output.
pub fn ask(question: &Question) -> (Option<i32>, Vec<String>) {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("here");
    fs::create_dir_all(folder.join("folder")).unwrap();
    for (name, bytes) in &question.files {
        fs::write(folder.join(name), bytes).unwrap();
    }
    #[cfg(unix)]
    for (to, link) in &question.links {
        std::os::unix::fs::symlink(to, folder.join(link)).unwrap();
    }
    let before = contents(&folder);
    let [out, err] = ["out", "err"].map(|name| place.path().join(name));
    let mut child = program::command()
        .args(question.args.iter().map(|arg| arg.replace('\0', "")))
        .current_dir(&folder)
        .env("RAYON_NUM_THREADS", "1")
        .stdin(Stdio::null())
        .stdout(File::create(&out).unwrap())
        .stderr(File::create(&err).unwrap())
        .spawn()
        .unwrap();
    let Some(status) = wait(&mut child) else {
        return (None, vec![format!("it takes more than {LONGEST:?}")]);
    };
    let [out, err] = [out, err].map(|path| fs::read(path).unwrap());
    let (out, err) = (String::from_utf8_lossy(&out), String::from_utf8_lossy(&err));
    let mut wrong = vec![];
    if !matches!(status.code(), Some(0..=2)) {
        wrong.push(format!("it ends with {status}: {err}"));
    }
    if err.contains("panicked") {
        wrong.push(format!("it panics: {err}"));
    }
    if status.code() == Some(2) && err.trim().is_empty() {
        wrong.push("status 2 without a message".into());
    }
    // with exit status 2, an error message may quote NaN from the input
    if status.code() != Some(2) {
        wrong.extend(numbers(question, &out));
    }
    if question.args.iter().any(|arg| arg == "--json") {
        wrong.extend(json(question, &out, status));
    }
    wrong.extend(touched(question, &before, &contents(&folder)));
    (status.code(), wrong)
}

fn wait(child: &mut Child) -> Option<ExitStatus> {
    let begun = Instant::now();
    let mut pause = Duration::from_millis(1);
    while begun.elapsed() < LONGEST {
        if let Some(status) = child.try_wait().unwrap() {
            return Some(status);
        }
        std::thread::sleep(pause);
        pause = (2 * pause).min(Duration::from_millis(2));
    }
    let _ = child.kill();
    let _ = child.wait();
    None
}

/// A fault with the first line of the output that has NaN or infinity. `None` without such a line,
/// or if the question itself may cause one.
fn numbers(question: &Question, out: &str) -> Option<String> {
    let words = |line: &str| -> Vec<String> {
        line.split(|c: char| !(c.is_alphanumeric() || c == '_'))
            .map(str::to_lowercase)
            .collect()
    };
    // a flat face has an infinite radius, and some parameters have infinite ranges; an answer may
    // also quote "inf" from an argument
    let has_infinities = matches!(
        question.command(),
        "parameters" | "presets" | "laws" | "compare"
    ) || question.args.iter().any(|arg| {
        arg.contains("radius") || arg.contains("inf") || arg == "all" || arg == "--json"
    }) || question
        .files
        .iter()
        .any(|(_, bytes)| String::from_utf8_lossy(bytes).contains("radius"));
    let asks_nan = question
        .args
        .iter()
        .any(|arg| arg.to_lowercase().contains("nan"))
        || question.files.iter().any(|(_, bytes)| {
            String::from_utf8_lossy(bytes)
                .to_lowercase()
                .contains("nan")
        });
    let bad = |line: &&str| {
        let words = words(line);
        (!asks_nan && words.iter().any(|word| word == "nan"))
            || (!has_infinities && words.iter().any(|word| word == "inf" || word == "infinity"))
    };
    out.lines()
        .find(bad)
        .map(|line| format!("no number: {line}"))
}

/// Faults of an answer in JSON.
fn json(question: &Question, out: &str, status: ExitStatus) -> Vec<String> {
    if question
        .args
        .iter()
        .any(|arg| matches!(arg.as_str(), "--help" | "--version" | "--"))
    {
        return vec![];
    }
    let answer: Value = match serde_json::from_str(out) {
        Ok(answer) => answer,
        Err(error) => return vec![format!("not one JSON object: {error}: {out}")],
    };
    let mut wrong = faults(question.command(), &answer);
    let printed = answer["status"].as_str().unwrap_or_default();
    let expected = if printed == "error" {
        2
    } else {
        i32::from(!FOUND.contains(&printed))
    };
    if status.code() != Some(expected) {
        wrong.push(format!(
            "the answer says '{printed}', and yet the exit status is {status}"
        ));
    }
    wrong
}

/// Every file below a folder, by its path.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(at) = folders.pop() {
        for entry in fs::read_dir(at).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().display().to_string();
                found.insert(name, fs::read(path).unwrap());
            }
        }
    }
    found
}

/// Faults of the files after a question: new files that no output names, and missing or changed
/// files.
fn touched(
    question: &Question,
    before: &BTreeMap<String, Vec<u8>>,
    after: &BTreeMap<String, Vec<u8>>,
) -> Vec<String> {
    let is_named = |name: &str| {
        let of = |output: &String| {
            let rest = name.strip_prefix(output.as_str());
            let folder = if output == "." {
                Some(name)
            } else {
                rest.and_then(|rest| rest.strip_prefix('/'))
            };
            rest.is_some_and(|rest| rest.is_empty() || COMPANIONS.contains(&rest))
                || folder.is_some()
        };
        question.outputs.iter().any(of)
    };
    // with --overwrite, the program may replace files that the command line names only as outputs
    let may_replace = |name: &str| {
        let is_told = question.args.iter().any(|arg| arg == "--overwrite");
        let through = question
            .links
            .iter()
            .find(|(to, link)| to == name && is_named(link));
        let is_output = through.is_some() || is_named(name);
        let times = question.args.iter().filter(|arg| *arg == name).count();
        is_told && is_output && times == usize::from(through.is_none())
    };
    let lost = before
        .iter()
        .filter(|(name, bytes)| after.get(*name) != Some(bytes) && !may_replace(name));
    let lost = lost.map(|(name, _)| format!("{name} was there before, and is changed"));
    let new = after
        .keys()
        .filter(|name| !before.contains_key(*name) && !is_named(name));
    let new = new.map(|name| format!("{name} is written, and no one named it"));
    lost.chain(new).collect()
}
