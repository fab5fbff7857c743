//! Atomic files: written to a temporary name in the same folder, then renamed.

use std::io;
use std::path::Path;
use tempfile::{PathPersistError, TempPath};

/// Creates a temporary file in the folder of `path`. The file is deleted when it is dropped, unless
/// [`persist`] renames it.
pub(crate) fn create_beside(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".longdrive-");
    #[cfg(unix)]
    {
        use std::{fs, os::unix::fs::PermissionsExt};
        // copy the permissions of the replaced file; a new file gets the default permissions
        let permissions = fs::metadata(path)
            .ok()
            .filter(fs::Metadata::is_file)
            .map(|found| found.permissions());
        builder.permissions(permissions.unwrap_or_else(|| fs::Permissions::from_mode(0o666)));
    }
    // omit the path of the temporary file from the error (privacy)
    builder
        .tempfile_in(folder_of(path))
        .map_err(|error| io::Error::from(error.kind()))
}

/// Renames a temporary file to its final path. An existing file is replaced only if `may_replace`;
/// otherwise the error is [`io::ErrorKind::AlreadyExists`].
pub(crate) fn persist(
    file: TempPath,
    at: &Path,
    may_replace: bool,
) -> Result<(), PathPersistError> {
    if may_replace {
        return file.persist(at);
    }
    match file.persist_noclobber(at) {
        // Some file systems have no rename that keeps an existing file. Check that there is no
        // file, and rename.
        Err(failed) if failed.error.kind() != io::ErrorKind::AlreadyExists && !at.exists() => {
            failed.path.persist(at)
        }
        done => done,
    }
}

/// The folder of a file; `.` for a name without a folder.
pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}
