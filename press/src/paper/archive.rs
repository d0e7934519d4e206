//! A ZIP archive, as far as an EPUB needs one: files packed or as they are, without dates.

use flate2::{Compression, Crc, write::DeflateEncoder};
use std::io::Write as _;

/// The day that stands for none: the first of January 1980.
const NO_DAY: u16 = 0x21;

#[derive(Debug, Default)]
pub(super) struct Archive {
    bytes: Vec<u8>,
    /// The heads of all files once more, which stand at the end.
    directory: Vec<u8>,
    files: u16,
}

impl Archive {
    /// Adds a file as it is.
    pub(super) fn store(&mut self, name: &str, bytes: &[u8]) {
        self.add(name, bytes, bytes, 0);
    }

    /// Adds a file, packed.
    pub(super) fn pack(&mut self, name: &str, bytes: &[u8]) {
        let mut packer = DeflateEncoder::new(Vec::new(), Compression::best());
        let packed = packer.write_all(bytes).and_then(|()| packer.finish());
        match packed {
            Ok(packed) => self.add(name, bytes, &packed, 8),
            Err(_) => self.store(name, bytes), // which memory never causes
        }
    }

    fn add(&mut self, name: &str, bytes: &[u8], packed: &[u8], method: u16) {
        let mut sum = Crc::new();
        sum.update(bytes);
        let start = self.bytes.len() as u32;
        // What both heads say: the version that can read it, flags (names are UTF-8), method, time, day, check sum,
        // sizes, length of the name, and of what comes behind it.
        let mut head = Vec::new();
        for word in [20, 1 << 11, method, 0, NO_DAY] {
            head.extend(word.to_le_bytes());
        }
        for number in [sum.sum(), packed.len() as u32, bytes.len() as u32] {
            head.extend(number.to_le_bytes());
        }
        for length in [name.len() as u16, 0] {
            head.extend(length.to_le_bytes());
        }
        self.bytes.extend(b"PK\x03\x04");
        self.bytes.extend(&head);
        self.bytes.extend(name.bytes());
        self.bytes.extend(packed);
        self.directory.extend(b"PK\x01\x02\x14\x00");
        self.directory.extend(&head);
        self.directory.extend([0; 10]); // no comment, one disk, no attributes
        self.directory.extend(start.to_le_bytes());
        self.directory.extend(name.bytes());
        self.files += 1;
    }

    /// The whole archive.
    pub(super) fn finish(mut self) -> Vec<u8> {
        let start = self.bytes.len() as u32;
        let length = self.directory.len() as u32;
        self.bytes.append(&mut self.directory);
        self.bytes.extend(b"PK\x05\x06\x00\x00\x00\x00");
        for count in [self.files, self.files] {
            self.bytes.extend(count.to_le_bytes());
        }
        for number in [length, start] {
            self.bytes.extend(number.to_le_bytes());
        }
        self.bytes.extend([0; 2]);
        self.bytes
    }
}
