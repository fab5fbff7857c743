use crate::atomic_file::{create_beside, persist};
use crate::batch::{StatusCounts, SweepDefinition};
use serde::{Deserialize, Serialize};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, BufRead, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The first line of a journal.
#[derive(Debug, Serialize, Deserialize)]
pub struct JournalHeader {
    #[serde(flatten)]
    pub definition: SweepDefinition,
    /// Format of the rows: `csv`, `csv in metric units`, `jsonl`, `parquet`.
    pub format: String,
    /// True if the rows may replace an existing file.
    pub overwrite: bool,
}

/// The progress of an incomplete file of rows, in a separate file `FILE.resume`. The first line is
/// the header. Each further line is an entry: it records that rows were written to the disk. An
/// incomplete last line, left by a killed program, is ignored.
pub struct Journal {
    path: PathBuf,
    file: File,
    /// For each entry, the size of the file of rows and the offset of the entry in the journal,
    /// bytes.
    entries: Vec<(u64, u64)>,
    /// Length of the journal, bytes.
    length: u64,
    pub header: JournalHeader,
    /// The replaced journal. It stays locked, because other programs may have opened it before it
    /// was replaced.
    _replaced: Option<File>,
}

/// The path with `suffix` appended to the file name.
pub fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    name.into()
}

/// An entry of the journal: the rows in the first `bytes` bytes of the file of rows.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct WrittenRows {
    /// Size, bytes.
    pub bytes: u64,
    /// Status counts; their total is the number of rows.
    #[serde(flatten)]
    pub status_counts: StatusCounts,
    /// The metadata of the Parquet row group that ends at `bytes`; empty for text.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub group: Vec<u8>,
}

impl Journal {
    /// The path of the journal for a file.
    pub fn path(of: &Path) -> PathBuf {
        with_suffix(of, ".resume")
    }

    /// Returns true for the journal of a sweep, whose first line is a header.
    ///
    /// # Errors
    /// If a sweep is writing the journal.
    pub fn is_one(path: &Path) -> io::Result<bool> {
        let Ok(file) = File::open(path) else {
            return Ok(false);
        };
        lock(&file)?;
        let mut line = String::new();
        let read = io::BufReader::new(file).read_line(&mut line);
        Ok(read.is_ok() && serde_json::from_str::<JournalHeader>(&line).is_ok())
    }

    /// Creates a journal atomically. A journal that another program is writing is never replaced;
    /// any other journal is replaced only with `overwrite`.
    pub fn begin(of: &Path, header: JournalHeader) -> io::Result<Self> {
        let path = Self::path(of);
        let replaced = if header.overwrite {
            File::open(&path).ok()
        } else {
            None
        };
        replaced.as_ref().map_or(Ok(()), lock)?;
        let mut beside = create_beside(&path)?;
        let mut line = serde_json::to_vec(&header)?;
        line.push(b'\n');
        beside.write_all(&line)?;
        beside.as_file().sync_all()?;
        // lock the journal before other programs can find it
        lock(beside.as_file())?;
        let (file, at) = beside.into_parts();
        // if two programs begin at the same time, the second one finds the journal of the first one
        persist(at, &path, replaced.is_some()).map_err(|failed| match failed.error.kind() {
            io::ErrorKind::AlreadyExists => busy(),
            _ => failed.error,
        })?;
        Ok(Self {
            path,
            file,
            entries: vec![],
            length: line.len() as u64,
            header,
            _replaced: replaced,
        })
    }

    /// Opens the journal of a file, and returns it with the entries. Removes the first entry that
    /// `keeps` rejects and all later entries. `None` if there is no journal.
    pub fn open(
        of: &Path,
        keeps: impl Fn(&WrittenRows) -> bool,
    ) -> io::Result<Option<(Self, Vec<WrittenRows>)>> {
        let path = Self::path(of);
        let mut file = match OpenOptions::new().read(true).write(true).open(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            file => file?,
        };
        lock(&file)?;
        let mut text = String::new();
        file.read_to_string(&mut text)?;
        // another program completed the sweep and emptied the journal after it was opened here, and
        // before it was locked
        if text.is_empty() {
            return Ok(None);
        }
        let mut lines = text
            .split_inclusive('\n')
            .take_while(|line| line.ends_with('\n'));
        let first = lines.next().unwrap_or_default();
        let mut journal = Self {
            path,
            file,
            entries: vec![],
            length: first.len() as u64,
            header: serde_json::from_str(first)?,
            _replaced: None,
        };
        let mut entries = vec![];
        for line in lines {
            let Some(entry) = serde_json::from_str::<WrittenRows>(line)
                .ok()
                .filter(&keeps)
            else {
                break;
            };
            journal.entries.push((entry.bytes, journal.length));
            journal.length += line.len() as u64;
            entries.push(entry);
        }
        cut(&mut journal.file, journal.length)?;
        Ok(Some((journal, entries)))
    }

    /// Adds an entry. Its rows must already be on the disk.
    pub fn add(&mut self, entry: &WrittenRows) -> io::Result<()> {
        let mut line = serde_json::to_vec(entry)?;
        line.push(b'\n');
        let written = self
            .file
            .write_all(&line)
            .and_then(|()| self.file.sync_data());
        if written.is_err() {
            cut(&mut self.file, self.length)?;
            return written;
        }
        self.entries.push((entry.bytes, self.length));
        self.length += line.len() as u64;
        Ok(())
    }

    /// Removes the entries of rows that end after the first `bytes` bytes of the file of rows.
    #[cfg(feature = "parquet")]
    pub fn forget_beyond(&mut self, bytes: u64) -> io::Result<()> {
        while let Some((_, at)) = self.entries.pop_if(|(of, _)| *of > bytes) {
            self.length = at;
        }
        cut(&mut self.file, self.length)
    }

    /// Removes the journal of a complete file.
    pub fn remove(&self) -> io::Result<()> {
        self.file.set_len(0)?;
        std::fs::remove_file(&self.path)
    }
}

/// Cuts a file after its first `length` bytes, and writes on from there.
pub fn cut(file: &mut File, length: u64) -> io::Result<()> {
    file.set_len(length)?;
    file.seek(SeekFrom::Start(length)).map(|_| ())
}

/// Locks a journal, because two sweeps that write one file would corrupt it.
fn lock(file: &File) -> io::Result<()> {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Err(busy()),
        // some file systems support no locks: continue without one
        _ => Ok(()),
    }
}

fn busy() -> io::Error {
    io::Error::other("another sweep is writing it")
}
