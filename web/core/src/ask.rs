//! Commands of the program, with files in memory.

use crate::message;
use crate::refusal::Refusal;
use crate::words::page_words;
use longdrive::command::{Host, MemoryFiles, Mention, MessageKind, Progress, Work, run};
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The name of the program, the first word of a command line.
const PROGRAM: &str = "longdrive";

/// Receives the number of completed parts of long work, and the number of all parts.
pub type ShowProgress = fn(done: f64, of: f64);

/// The largest answer, bytes.
const MOST_BYTES: usize = 64_000_000;

/// The head of a request: a command line, and the names and sizes of the files in the block.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    words: Vec<String>,
    #[serde(default)]
    files: Vec<FileOfBlock>,
}

/// A file whose content is in the block.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct FileOfBlock {
    name: String,
    bytes: usize,
}

#[derive(Serialize)]
struct Head {
    status: &'static str,
    exit: u8,
    answer: String,
    said: Vec<ShownMessage>,
    files: Vec<FileOfBlock>,
}

/// A message of the command in addition to its answer.
#[derive(Serialize)]
struct ShownMessage {
    kind: &'static str,
    text: String,
}

/// Runs the command, and answers with its output; the block has the files that it wrote.
///
/// # Errors
/// If the block is shorter than the contents of the input files.
pub fn answer(request: &Request, block: &[u8], show: ShowProgress) -> Result<Vec<u8>, Refusal> {
    let page = Arc::new(Page {
        inputs: inputs(&request.files, block)?,
        show,
        answer: Mutex::default(),
        said: Mutex::default(),
        outputs: Mutex::default(),
    });
    let words = [PROGRAM]
        .into_iter()
        .chain(request.words.iter().map(String::as_str));
    let exit = run(words.map(OsString::from).collect(), page.clone());
    let outputs = std::mem::take(&mut *lock(&page.outputs));
    let files = outputs.iter().map(|(name, content)| FileOfBlock {
        name: name.display().to_string(),
        bytes: content.len(),
    });
    let head = Head {
        status: match exit {
            0 => "done",
            1 => "no-answer",
            _ => "error",
        },
        exit,
        answer: String::from_utf8_lossy(&lock(&page.answer)).into_owned(),
        said: std::mem::take(&mut *lock(&page.said)),
        files: files.collect(),
    };
    let contents: Vec<_> = outputs.into_iter().map(|(_, content)| content).collect();
    Ok(message::written(&head, &contents.concat()))
}

/// Splits the block into the contents of the input files.
fn inputs(files: &[FileOfBlock], mut block: &[u8]) -> Result<MemoryFiles, Refusal> {
    let mut inputs = MemoryFiles::new();
    for file in files {
        let Some((content, rest)) = block.split_at_checked(file.bytes) else {
            let why = format!("the block ends within the file '{}'", file.name);
            return Err(Refusal::of_request(&why));
        };
        inputs.insert(PathBuf::from(&file.name), content.into());
        block = rest;
    }
    Ok(inputs)
}

/// The page, which is the host of its commands.
struct Page {
    inputs: MemoryFiles,
    show: ShowProgress,
    answer: Mutex<Vec<u8>>,
    said: Mutex<Vec<ShownMessage>>,
    outputs: Mutex<Vec<(PathBuf, Vec<u8>)>>,
}

/// Locks a value that stays usable after a panic.
fn lock<T>(value: &Mutex<T>) -> MutexGuard<'_, T> {
    value.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the escape sequences of colours from a text.
fn plain(text: &str) -> String {
    anstream::adapter::strip_str(text).to_string()
}

impl Host for Page {
    fn print(&self, text: &str) -> io::Result<()> {
        self.write(plain(text).as_bytes())
    }

    fn write(&self, rows: &[u8]) -> io::Result<()> {
        let mut answer = lock(&self.answer);
        if answer.len() + rows.len() > MOST_BYTES {
            let why = "it is larger than 64 MB, the largest answer of a page";
            return Err(io::Error::other(why));
        }
        answer.extend_from_slice(rows);
        Ok(())
    }

    fn say(&self, kind: MessageKind, text: &str) {
        let kind = kind.name();
        let text = plain(text);
        lock(&self.said).push(ShownMessage { kind, text });
    }

    fn mention(&self, mention: Mention<'_>) -> String {
        page_words(mention)
    }

    fn files(&self) -> MemoryFiles {
        self.inputs.clone()
    }

    fn keeps(&self, _: &Path) -> bool {
        true
    }

    fn keep(&self, name: &Path, content: Vec<u8>) {
        lock(&self.outputs).push((name.into(), content));
    }

    fn show_progress(&self, _: Work<'_>) -> Arc<dyn Progress> {
        Arc::new(Bar {
            show: self.show,
            position: AtomicU64::new(0),
            length: AtomicU64::new(0),
        })
    }
}

/// Progress that the page shows while the command runs.
struct Bar {
    show: ShowProgress,
    position: AtomicU64,
    length: AtomicU64,
}

impl Bar {
    fn changed(&self) {
        let [position, length] =
            [&self.position, &self.length].map(|of| of.load(Ordering::Relaxed) as f64);
        if length > 0.0 {
            (self.show)(position, length);
        }
    }
}

impl Progress for Bar {
    fn set_length(&self, parts: u64) {
        self.length.store(parts, Ordering::Relaxed);
    }

    fn set_position(&self, parts: u64) {
        self.position.store(parts, Ordering::Relaxed);
        self.changed();
    }

    fn inc(&self, parts: u64) {
        self.position.fetch_add(parts, Ordering::Relaxed);
        self.changed();
    }
}
