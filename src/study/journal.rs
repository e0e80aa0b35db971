//! A journal: the rows of a sweep that are done, beside its output, so that one that was killed
//! goes on where it was.
//!
//! ```text
//! "flexure journal 1\n"  lines "name: value\n"  "\n"  checksum
//! block: length of the rows in bytes (u32), number of rows (u32), first row (u64), rows, checksum
//! row:   status (u8), number of measures (u32), measures (f64), length of the message (u32), message
//! ```
//!
//! Numbers are little-endian; a checksum is the XXH3 (64 bits) of all before it in its block. A block
//! that is cut off or damaged, and all after it, counts as not written.

use std::fmt;
use std::fs::{self, File, TryLockError};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use xxhash_rust::xxh3::xxh3_64;

use super::{Row, Status};

const MAGIC: &str = "flexure journal 1\n";
/// Length of a block's head in bytes.
const HEAD: usize = 16;
/// No head of a journal is as long.
const LONGEST_HEADER: u64 = 16 << 20;

/// A journal that is being written.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
    /// Where its blocks begin.
    start: u64,
    rows: usize,
}

/// Why there is no journal to go on with.
#[derive(Debug)]
pub enum JournalFailure {
    /// It cannot be read or written.
    File(io::Error),
    /// Another process writes it.
    InUse,
    /// The file is no journal.
    Foreign,
    /// It is of another sweep: the first thing that differs, as it is there and as it is now.
    Differs {
        /// What differs.
        name: String,
        /// Its value in the journal.
        there: String,
        /// Its value now.
        now: String,
    },
}

impl From<io::Error> for JournalFailure {
    fn from(error: io::Error) -> Self {
        Self::File(error)
    }
}

impl fmt::Display for JournalFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(error) => error.fmt(f),
            Self::InUse => f.write_str("another run is writing it"),
            Self::Foreign => f.write_str("it is no journal of a sweep"),
            Self::Differs { name, there, now } => {
                write!(f, "its {name} is `{there}`, and now it is `{now}`")
            }
        }
    }
}

impl std::error::Error for JournalFailure {}

impl Journal {
    /// Opens the journal at `path`, or begins it. `identity` is what rows depend on besides their
    /// design points, each thing with its name; a journal with any other is refused.
    ///
    /// # Errors
    ///
    /// If it cannot be read or written, is in use, or is of another sweep. It is left as it was then.
    pub fn open(path: &Path, identity: &[(&str, String)]) -> Result<Self, JournalFailure> {
        let mut file = File::options()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(path)?;
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(JournalFailure::InUse);
        }
        let header = header(identity);
        let mut journal = match read_header(&mut file)? {
            Some(found) if found == header => Self {
                path: path.to_owned(),
                start: header.len() as u64 + 8,
                file,
                rows: 0,
            },
            Some(found) => return Err(difference(&found, identity)),
            None => {
                file.set_len(0)?;
                file.seek(SeekFrom::Start(0))?;
                let mut bytes = header.into_bytes();
                bytes.extend(xxh3_64(&bytes).to_le_bytes());
                file.write_all(&bytes)?;
                Self {
                    path: path.to_owned(),
                    start: bytes.len() as u64,
                    file,
                    rows: 0,
                }
            }
        };
        let (rows, end) = journal.scan(&mut |_| Ok(()))?;
        journal.rows = rows;
        journal.file.set_len(end)?;
        journal.file.seek(SeekFrom::Start(end))?;
        Ok(journal)
    }

    /// Number of rows in it.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Adds rows, which follow those that are in it.
    ///
    /// # Errors
    ///
    /// If it cannot be written.
    pub fn append(&mut self, rows: &[Row]) -> io::Result<()> {
        let mut block = vec![0; HEAD];
        for row in rows {
            let status = Status::ALL.iter().position(|&known| known == row.status);
            block.push(status.unwrap_or_default() as u8);
            block.extend((row.measures.len() as u32).to_le_bytes());
            for measure in &row.measures {
                block.extend(measure.to_bits().to_le_bytes());
            }
            block.extend((row.message.len() as u32).to_le_bytes());
            block.extend(row.message.as_bytes());
        }
        let length = u32::try_from(block.len() - HEAD).map_err(io::Error::other)?;
        block[..4].copy_from_slice(&length.to_le_bytes());
        block[4..8].copy_from_slice(&(rows.len() as u32).to_le_bytes());
        block[8..HEAD].copy_from_slice(&(self.rows as u64).to_le_bytes());
        block.extend(xxh3_64(&block).to_le_bytes());
        self.file.write_all(&block)?;
        self.rows += rows.len();
        Ok(())
    }

    /// Hands all rows to `each`, in order. They have no points: a journal does not keep what its
    /// sweep knows.
    ///
    /// # Errors
    ///
    /// If it cannot be read, or what `each` gives.
    pub fn read(&mut self, mut each: impl FnMut(Row) -> io::Result<()>) -> io::Result<()> {
        let (rows, end) = self.scan(&mut each)?;
        self.file.seek(SeekFrom::Start(end))?;
        if rows != self.rows {
            return Err(io::Error::other("the journal was changed meanwhile"));
        }
        Ok(())
    }

    /// Removes it.
    ///
    /// # Errors
    ///
    /// If it cannot be removed.
    pub fn remove(self) -> io::Result<()> {
        fs::remove_file(&self.path)
    }

    /// Reads sound blocks: the number of their rows, and where they end.
    fn scan(&self, each: &mut dyn FnMut(Row) -> io::Result<()>) -> io::Result<(usize, u64)> {
        let length = self.file.metadata()?.len();
        let mut file = &self.file;
        file.seek(SeekFrom::Start(self.start))?;
        let mut reader = BufReader::with_capacity(1 << 16, file);
        let (mut rows, mut end) = (0, self.start);
        while let Some(block) = read_block(&mut reader, length - end)? {
            let first = u64_at(&block, 8);
            let Some(read) = decode(&block, rows).filter(|_| first == rows as u64) else {
                break;
            };
            rows += read.len();
            end += block.len() as u64 + 8;
            for row in read {
                each(row)?;
            }
        }
        Ok((rows, end))
    }
}

fn header(identity: &[(&str, String)]) -> String {
    let mut text = MAGIC.to_owned();
    for (name, value) in identity {
        let value = value.replace(['\n', '\r'], " ");
        text.push_str(&format!("{name}: {value}\n"));
    }
    text.push('\n');
    text
}

/// The header of a journal; `None` where there is no whole one yet.
fn read_header(file: &mut File) -> Result<Option<String>, JournalFailure> {
    let mut bytes = Vec::new();
    file.seek(SeekFrom::Start(0))?;
    file.take(LONGEST_HEADER).read_to_end(&mut bytes)?;
    let magic = MAGIC.as_bytes();
    if !bytes.starts_with(&magic[..magic.len().min(bytes.len())]) {
        return Err(JournalFailure::Foreign);
    }
    let end = bytes.windows(2).position(|pair| pair == b"\n\n");
    let Some(end) = end.map(|end| end + 2) else {
        return Ok(None);
    };
    let checksum = bytes.get(end..end + 8);
    if checksum != Some(&xxh3_64(&bytes[..end]).to_le_bytes()[..]) {
        return Ok(None);
    }
    bytes.truncate(end);
    Ok(String::from_utf8(bytes).ok())
}

fn difference(found: &str, identity: &[(&str, String)]) -> JournalFailure {
    let lines = found
        .lines()
        .skip(1)
        .filter_map(|line| line.split_once(": "));
    let there: Vec<(&str, &str)> = lines.collect();
    let differing = identity.iter().find_map(|(name, now)| {
        let now = now.replace(['\n', '\r'], " ");
        let value = there.iter().find(|(other, _)| other == name);
        let value = value.map_or("", |(_, value)| *value);
        (value != now).then(|| JournalFailure::Differs {
            name: (*name).to_owned(),
            there: value.to_owned(),
            now,
        })
    });
    differing.unwrap_or(JournalFailure::Foreign)
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    let mut number = [0; 4];
    number.copy_from_slice(&bytes[at..at + 4]);
    u32::from_le_bytes(number)
}

fn u64_at(bytes: &[u8], at: usize) -> u64 {
    let mut number = [0; 8];
    number.copy_from_slice(&bytes[at..at + 8]);
    u64::from_le_bytes(number)
}

/// The next block without its checksum, if it is whole and sound; `left` bytes are in the file.
fn read_block(reader: &mut impl Read, left: u64) -> io::Result<Option<Vec<u8>>> {
    if left < HEAD as u64 + 8 {
        return Ok(None);
    }
    let mut block = vec![0; HEAD];
    reader.read_exact(&mut block)?;
    let rows = u64::from(u32_at(&block, 0));
    if rows > left - HEAD as u64 - 8 {
        return Ok(None);
    }
    block.resize(HEAD + rows as usize, 0);
    reader.read_exact(&mut block[HEAD..])?;
    let mut checksum = [0; 8];
    reader.read_exact(&mut checksum)?;
    Ok((u64::from_le_bytes(checksum) == xxh3_64(&block)).then_some(block))
}

/// The rows of a block, of which the first is row `first`.
fn decode(block: &[u8], first: usize) -> Option<Vec<Row>> {
    let mut rest = &block[HEAD..];
    let mut take = |count: usize| -> Option<&[u8]> {
        let (taken, left) = rest.split_at_checked(count)?;
        rest = left;
        Some(taken)
    };
    let mut rows = Vec::new();
    for index in 0..u32_at(block, 4) as usize {
        let status = *Status::ALL.get(usize::from(take(1)?[0]))?;
        let measures = u32_at(take(4)?, 0) as usize;
        let measures = take(measures.checked_mul(8)?)?.chunks_exact(8);
        let measures = measures.map(|bytes| f64::from_bits(u64_at(bytes, 0)));
        let measures = measures.collect();
        let message = u32_at(take(4)?, 0) as usize;
        let message = std::str::from_utf8(take(message)?).ok()?.to_owned();
        rows.push(Row {
            index: first + index,
            point: Vec::new(),
            measures,
            status,
            message,
        });
    }
    Some(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(index: usize) -> Row {
        let failed = index % 3 == 2;
        Row {
            index,
            point: Vec::new(),
            measures: if failed {
                Vec::new()
            } else {
                vec![index as f64 / 7.0, f64::NAN, -0.0]
            },
            status: if failed {
                Status::Refused
            } else {
                Status::Done
            },
            message: if failed {
                format!("no. {index}: it does not close — 3 µm")
            } else {
                String::new()
            },
        }
    }

    fn identity() -> Vec<(&'static str, String)> {
        vec![("model", "a 1".to_owned()), ("path", "avx2".to_owned())]
    }

    fn place(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("flexure-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        folder.join("out.csv.journal")
    }

    fn contents(path: &Path) -> Vec<Row> {
        let mut rows = Vec::new();
        let mut journal = Journal::open(path, &identity()).unwrap();
        journal
            .read(|row| {
                rows.push(row);
                Ok(())
            })
            .unwrap();
        assert_eq!(rows.len(), journal.rows());
        rows
    }

    fn same(a: &[Row], b: &[Row]) -> bool {
        format!("{a:?}") == format!("{b:?}")
    }

    #[test]
    fn cut_off_anywhere_it_goes_on_to_the_same_rows() {
        let path = place("cut");
        let all: Vec<Row> = (0..12).map(row).collect();
        let mut journal = Journal::open(&path, &identity()).unwrap();
        for block in all.chunks(4) {
            journal.append(block).unwrap();
        }
        drop(journal);
        let whole = fs::read(&path).unwrap();
        assert!(same(&contents(&path), &all));
        for length in 0..whole.len() {
            fs::write(&path, &whole[..length]).unwrap();
            let mut journal = Journal::open(&path, &identity()).unwrap();
            let rows = journal.rows();
            assert!(rows < 12 && rows.is_multiple_of(4), "{rows} at {length}");
            journal.append(&all[rows..]).unwrap();
            drop(journal);
            assert!(same(&contents(&path), &all), "cut at {length}");
        }
    }

    #[test]
    fn damage_is_found_wherever_it_is() {
        let path = place("damage");
        let all: Vec<Row> = (0..6).map(row).collect();
        let mut journal = Journal::open(&path, &identity()).unwrap();
        let start = journal.start as usize;
        for block in all.chunks(2) {
            journal.append(block).unwrap();
        }
        drop(journal);
        let whole = fs::read(&path).unwrap();
        for at in start..whole.len() {
            let mut damaged = whole.clone();
            damaged[at] ^= 0x10;
            fs::write(&path, &damaged).unwrap();
            let rows = contents(&path);
            assert!(rows.len() < 6 && same(&rows, &all[..rows.len()]));
        }
    }

    #[test]
    fn another_sweep_is_refused_and_named() {
        let path = place("other");
        let mut journal = Journal::open(&path, &identity()).unwrap();
        journal.append(&[row(0)]).unwrap();
        let again = Journal::open(&path, &identity()).unwrap_err();
        assert!(matches!(again, JournalFailure::InUse), "{again}");
        drop(journal);
        let other = [("model", "a 1".to_owned()), ("path", "avx512".to_owned())];
        let error = Journal::open(&path, &other).unwrap_err();
        assert_eq!(
            error.to_string(),
            "its path is `avx2`, and now it is `avx512`"
        );
        assert_eq!(contents(&path).len(), 1);
        fs::write(&path, "f,Fp\n1,2\n").unwrap();
        let error = Journal::open(&path, &identity()).unwrap_err();
        assert!(matches!(error, JournalFailure::Foreign));
        assert_eq!(fs::read_to_string(&path).unwrap(), "f,Fp\n1,2\n");
    }
}
