//! Files that are written whole or not at all.

use std::fs;
use std::path::{Path, PathBuf};

/// Writes all files: each into a temporary file beside its place first, and only when all are there does each get
/// its name, so that a full disk leaves what was there before.
pub fn write_all(files: &[(PathBuf, String)]) -> Result<(), String> {
    let temporary = |path: &Path| {
        let mut name = path.file_name().unwrap_or_default().to_owned();
        name.push(format!(".{}.tmp", std::process::id()));
        path.with_file_name(name)
    };
    let steps = || {
        for (path, text) in files {
            fs::write(temporary(path), text)
                .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        }
        for (path, _) in files {
            fs::rename(temporary(path), path)
                .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        }
        Ok(())
    };
    let written = steps();
    if written.is_err() {
        for (path, _) in files {
            // The sentence about the write is the one to show; a temporary file may be gone or never made.
            let _ = fs::remove_file(temporary(path));
        }
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_or_none() {
        let dir = std::env::temp_dir().join(format!("ombra-grade-whole-{}", std::process::id()));
        fs::create_dir_all(&dir).unwrap();
        let good = dir.join("good");
        let bad = dir.join("no such folder").join("bad");
        let why = write_all(&[(good.clone(), "1".into()), (bad, "2".into())]).unwrap_err();
        assert!(why.starts_with("cannot write "), "{why}");
        assert_eq!(fs::read_dir(&dir).unwrap().count(), 0);
        write_all(&[(good.clone(), "1".into())]).unwrap();
        write_all(&[(good.clone(), "3".into())]).unwrap();
        assert_eq!(fs::read_to_string(&good).unwrap(), "3");
        assert_eq!(fs::read_dir(&dir).unwrap().count(), 1);
        fs::remove_dir_all(&dir).unwrap();
    }
}
