//! Input files: on disk, or in memory.
//!
//! Every reader of tables, setups and swings opens its file here. A host program without a disk, or
//! with tables of its own, runs a command with files in memory: [`with_memory_files`].

use crate::thread_stack::with_innermost;
use std::cell::RefCell;
use std::collections::HashMap;
use std::fs::File;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Contents of files in memory by name. A file in memory hides a file of the same name on disk.
pub type MemoryFiles = HashMap<PathBuf, Arc<[u8]>>;

thread_local! {
    /// Files of the calls of [`with_memory_files`] on this thread, the innermost call last.
    static MEMORY: RefCell<Vec<MemoryFiles>> = const { RefCell::new(vec![]) };
}

/// Runs `work` on this thread. `work` can open `files` as if they were on disk. It cannot open the
/// files in memory of an outer call.
pub fn with_memory_files<T>(files: MemoryFiles, work: impl FnOnce() -> T) -> T {
    with_innermost(&MEMORY, files, work)
}

fn in_memory(path: &Path) -> Option<Arc<[u8]>> {
    MEMORY.with_borrow(|all| all.last()?.get(path).cloned())
}

/// True for the name of a file in memory.
pub fn is_in_memory(path: &Path) -> bool {
    in_memory(path).is_some()
}

/// True for a file in memory or on disk.
pub fn exists(path: &Path) -> bool {
    is_in_memory(path) || path.exists()
}

/// The extension of a table in lower case. A file in memory without an extension is CSV.
pub fn table_extension(path: &Path) -> String {
    match path.extension() {
        None if is_in_memory(path) => "csv".into(),
        extension => extension
            .unwrap_or_default()
            .to_string_lossy()
            .to_lowercase(),
    }
}

/// An open input file.
pub enum InputFile {
    Disk(File),
    Memory(Cursor<Arc<[u8]>>),
}

impl InputFile {
    /// Opens a file in memory, or else on disk.
    ///
    /// # Errors
    /// If the file on disk cannot be opened.
    pub fn open(path: &Path) -> io::Result<Self> {
        Ok(match in_memory(path) {
            Some(content) => Self::Memory(Cursor::new(content)),
            None => Self::Disk(File::open(path)?),
        })
    }

    /// The text of a file.
    ///
    /// # Errors
    /// If the file cannot be read, or is not UTF-8.
    pub fn read_to_string(path: &Path) -> io::Result<String> {
        let mut text = String::new();
        Self::open(path)?.read_to_string(&mut text)?;
        Ok(text)
    }

    /// The size in bytes.
    ///
    /// # Errors
    /// If the file system does not report the size.
    #[cfg_attr(
        not(any(feature = "arrow", feature = "parquet")),
        expect(dead_code, reason = "for binary tables")
    )]
    pub fn size(&self) -> io::Result<u64> {
        match self {
            Self::Disk(file) => Ok(file.metadata()?.len()),
            Self::Memory(content) => Ok(content.get_ref().len() as u64),
        }
    }
}

impl Read for InputFile {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::Disk(file) => file.read(into),
            Self::Memory(content) => content.read(into),
        }
    }
}

impl Seek for InputFile {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match self {
            Self::Disk(file) => file.seek(to),
            Self::Memory(content) => content.seek(to),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{InputFile, exists, table_extension, with_memory_files};
    use std::path::Path;
    use std::sync::Arc;

    #[test]
    fn exact_files_in_memory_are_read_within_their_work_only() {
        let name = Path::new("no folder/shots");
        let files = [(name.to_owned(), Arc::from(&b"a,b\n"[..]))].into();
        let read = with_memory_files(files, || {
            assert!(exists(name));
            assert_eq!(table_extension(name), "csv");
            InputFile::read_to_string(name).unwrap()
        });
        assert_eq!(read, "a,b\n");
        assert!(!exists(name));
        assert_eq!(table_extension(name), "");
    }
}
