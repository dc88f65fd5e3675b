use std::fs::{self, File};
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};

use super::console::{Fault, Mistake, legible, reason};
use super::{interrupt, progress};

/// Where a result goes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Target {
    /// Standard output.
    Stdout,
    /// A file.
    File(PathBuf),
}

impl Target {
    /// The target of `-o`: `-` is standard output.
    pub(super) fn from_argument(path: &Path) -> Self {
        if path == Path::new("-") { Self::Stdout } else { Self::File(path.into()) }
    }

    /// The form of a result: the one asked for, or else that of the file's extension, and the usual one on standard output.
    /// `known` names the extensions.
    pub(super) fn form<F>(
        &self,
        asked_for: Option<F>,
        usual: F,
        of_extension: impl Fn(&Path) -> Option<F>,
        known: &str,
    ) -> Result<F, Mistake> {
        match (asked_for, self) {
            (Some(form), _) => Ok(form),
            (None, Self::Stdout) => Ok(usual),
            (None, Self::File(path)) => of_extension(path).ok_or_else(|| {
                let path = legible(path);
                Mistake(format!("the extension of '{path}' is none of {known}: name the form with --format"))
            }),
        }
    }

    /// Refuses to write a result over one of the scenes it is made from.
    pub(super) fn refuse_to_overwrite(&self, scenes: &[PathBuf]) -> Result<(), Mistake> {
        let Self::File(path) = self else { return Ok(()) };
        let Ok(there) = path.canonicalize() else { return Ok(()) };
        match scenes.iter().find(|scene| scene.canonicalize().is_ok_and(|scene| scene == there && scene.is_file())) {
            Some(scene) => Err(Mistake(format!("the result would overwrite the scene '{}'", legible(scene)))),
            None => Ok(()),
        }
    }

    /// Writes a result. A file appears whole or not at all; a pipe that nobody reads any more ends it quietly.
    pub(super) fn write(&self, produce: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Fault> {
        let (name, written) = match self {
            Self::Stdout => {
                if io::stdout().is_terminal() {
                    drop(progress::clear());
                }
                ("<stdout>".into(), buffered(io::stdout().lock(), produce))
            }
            Self::File(path) => (legible(path), write_file(path, produce)),
        };
        match written {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                Err(Fault(format!("{name}: cannot be written: its folder does not exist")))
            }
            Err(error) => Err(Fault(format!("{name}: cannot be written: {}", reason(&error)))),
            Ok(()) => Ok(()),
        }
    }

    /// Prints the path of a file that was written, byte for byte for other programs, on a terminal so that it steers nothing.
    pub(super) fn announce(&self) -> Result<(), Fault> {
        let Self::File(path) = self else { return Ok(()) };
        let name = if io::stdout().is_terminal() {
            legible(path).into_bytes()
        } else {
            path.as_os_str().as_encoded_bytes().into()
        };
        Self::Stdout.write(|out| out.write_all(&name).and_then(|()| out.write_all(b"\n")))
    }
}

fn write_file(path: &Path, produce: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    match fs::metadata(path) {
        Ok(there) if there.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Err(_) if path.as_os_str().as_encoded_bytes().ends_with(b"/") => Err(io::ErrorKind::IsADirectory.into()),
        // A device or a named pipe cannot be replaced by a file.
        Ok(there) if !there.is_file() => buffered(File::options().write(true).open(path)?, produce),
        _ => write_whole(path, produce),
    }
}

/// Writes beside the file and moves the result there once it is complete. A file that is there keeps its permissions.
fn write_whole(path: &Path, produce: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let path = followed(path)?;
    let permissions = permissions(&path)?;
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".snellius-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As for any new file: the process's umask takes away what it takes away.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut file = interrupt::create(|| builder.tempfile_in(folder))?;
    buffered(file.as_file_mut(), produce)?;
    if let Some(permissions) = permissions {
        file.as_file().set_permissions(permissions)?;
    }
    match file.as_file().sync_all() {
        // Some file systems cannot tell whether the bytes have reached the disk; others tell only now that they have not.
        Err(error) if !matches!(error.kind(), io::ErrorKind::Unsupported | io::ErrorKind::InvalidInput) => Err(error),
        _ => interrupt::complete(file, &path),
    }
}

/// What a link leads to is replaced or made, not the link.
fn followed(path: &Path) -> io::Result<PathBuf> {
    match path.canonicalize() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => match fs::read_link(path) {
            // A link to what is not there; one round leads to no end, which `canonicalize` tells.
            Ok(target) => followed(&path.with_file_name("").join(target)),
            Err(_) => Ok(path.into()),
        },
        found => found,
    }
}

/// The permissions of a file that may be replaced; `None` where there is none yet. Only its folder need be writable to
/// replace a file, and so what its own permissions forbid is asked for here.
fn permissions(path: &Path) -> io::Result<Option<fs::Permissions>> {
    let permissions = match fs::metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        metadata => metadata?.permissions(),
    };
    // Some users may open even what nobody may write.
    if permissions.readonly() {
        return Err(io::Error::other("this file is read-only"));
    }
    File::options().write(true).open(path)?;
    Ok(Some(permissions))
}

fn buffered(out: impl Write, produce: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    produce(&mut out)?;
    out.flush()
}
