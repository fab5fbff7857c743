//! Files that are written beside their place and put there once they are whole.

use std::io;
use std::path::Path;
use tempfile::{PathPersistError, TempPath};

/// A new file in the same folder, which is gone again unless it is put in place.
pub(crate) fn create_beside(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".longdrive-");
    #[cfg(unix)]
    {
        use std::{fs, os::unix::fs::PermissionsExt};
        // those of the file that is replaced; of a new one, those that any new file has
        let of_old = fs::metadata(path)
            .ok()
            .filter(fs::Metadata::is_file)
            .map(|found| found.permissions());
        builder.permissions(of_old.unwrap_or_else(|| fs::Permissions::from_mode(0o666)));
    }
    // the name of this file is nobody's business
    builder
        .tempfile_in(folder_of(path))
        .map_err(|error| io::Error::from(error.kind()))
}

/// Puts a file in its place. One that is there is replaced only if that is allowed; else it stays
/// ([`io::ErrorKind::AlreadyExists`]).
pub(crate) fn persist(
    file: TempPath,
    at: &Path,
    may_replace: bool,
) -> Result<(), PathPersistError> {
    if may_replace {
        return file.persist(at);
    }
    match file.persist_noclobber(at) {
        // some file systems have no way to do both in one step
        Err(failed) if failed.error.kind() != io::ErrorKind::AlreadyExists && !at.exists() => {
            failed.path.persist(at)
        }
        done => done,
    }
}

/// The folder that a file is in.
pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}
