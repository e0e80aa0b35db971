//! Files that the command writes: checked before long work, and complete when they appear.
//!
//! A file is written beside its final place under another name and renamed at the end, so that
//! nobody ever reads half of one.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::Failure;

/// A file on its way to its final place.
pub struct OutputFile {
    target: PathBuf,
    /// Where it is written meanwhile; `None` for what is no regular file (a device, a pipe).
    beside: Option<PathBuf>,
    writer: BufWriter<File>,
}

impl OutputFile {
    /// Opens a file for writing; this is also the check that the place can be written to.
    ///
    /// # Errors
    ///
    /// A failure that names the file and says in words why it cannot be written.
    pub fn create(target: &Path) -> Result<Self, Failure> {
        check_place(target)?;
        let regular = fs::metadata(target).map_or(true, |data| data.is_file());
        if !regular {
            let file = File::options().write(true).open(target);
            let file = file.map_err(|why| cannot_write(target, &why))?;
            return Ok(Self {
                target: target.to_owned(),
                beside: None,
                writer: BufWriter::new(file),
            });
        }
        // A link is followed, so that the file behind it is replaced and not the link.
        let target = fs::canonicalize(target).unwrap_or_else(|_| target.to_owned());
        let mut name = OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(format!(".{}.partial", std::process::id()));
        let beside = target.with_file_name(name);
        let file = File::create(&beside).map_err(|why| cannot_write(&target, &why))?;
        Ok(Self {
            target,
            beside: Some(beside),
            writer: BufWriter::with_capacity(1 << 16, file),
        })
    }

    /// Puts the complete file in its place.
    ///
    /// # Errors
    ///
    /// A failure that says why it could not be completed, such as a full disk.
    pub fn finish(mut self) -> Result<(), Failure> {
        let done = self.writer.flush().and_then(|()| match self.beside.take() {
            Some(beside) => fs::rename(&beside, &self.target).inspect_err(|_| {
                let _ = fs::remove_file(&beside);
            }),
            None => Ok(()),
        });
        done.map_err(|why| cannot_write(&self.target, &why))
    }

    /// Writes a whole text and puts the file in its place.
    ///
    /// # Errors
    ///
    /// As [`OutputFile::finish`].
    pub fn finish_with(mut self, text: &str) -> Result<(), Failure> {
        self.write_all(text.as_bytes())
            .map_err(|why| cannot_write(&self.target, &why))?;
        self.finish()
    }
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer.flush()
    }
}

impl Drop for OutputFile {
    fn drop(&mut self) {
        if let Some(beside) = &self.beside {
            let _ = fs::remove_file(beside);
        }
    }
}

/// Checks that a file may be written there, as far as that shows without writing it.
///
/// # Errors
///
/// A failure that names the file and says in words why it cannot be written.
pub fn check_place(target: &Path) -> Result<(), Failure> {
    let fault = |why: &str| {
        Err(Failure::run(format!(
            "cannot write `{}`: {why}",
            target.display()
        )))
    };
    if target.is_dir() {
        return fault("it is a folder; name a file in it");
    }
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        return fault(&format!("there is no folder `{}`", folder.display()));
    }
    if fs::metadata(target).is_ok_and(|data| data.is_file() && data.permissions().readonly()) {
        return fault("the file is write-protected");
    }
    Ok(())
}

/// Refuses to write over the model file.
///
/// # Errors
///
/// If `target` is that file.
pub fn spare_model(target: &Path, model: &Path) -> Result<(), Failure> {
    if same_file(target, model) {
        return Err(Failure::usage(format!(
            "writing `{}` would overwrite the model",
            target.display()
        )));
    }
    Ok(())
}

/// Whether both name one file, whether it is there or not.
pub fn same_file(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b,
    }
}

/// The failure to write a file, in words.
pub fn cannot_write(target: &Path, why: &io::Error) -> Failure {
    let why = match why.kind() {
        io::ErrorKind::PermissionDenied => "no permission to write there".to_owned(),
        io::ErrorKind::StorageFull => "the disk is full".to_owned(),
        io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only".to_owned(),
        _ => why.to_string(),
    };
    Failure::run(format!("cannot write `{}`: {why}", target.display()))
}
