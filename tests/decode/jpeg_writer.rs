//! A writer of JPEG files whose blocks are constant: every decoded value is known exactly, for any sampling and scan structure.

/// What to write. Each 8 x 8 block of component `c` at block column and row has the value `value(c, column, row)`.
pub struct Jpeg<'a> {
    pub width: u16,
    pub height: u16,
    /// Identifier and horizontal and vertical sampling factors of each component.
    pub components: &'a [(u8, usize, usize)],
    pub progressive: bool,
    /// One scan of all components, or one scan each.
    pub interleaved: bool,
    /// Minimum coded units between restart markers; 0 for none.
    pub restart_interval: usize,
    /// The transform in an Adobe segment, where one is written.
    pub adobe_transform: Option<u8>,
}

impl<'a> Jpeg<'a> {
    /// A baseline JPEG of one scan.
    pub fn baseline(width: u16, height: u16, components: &'a [(u8, usize, usize)]) -> Self {
        Self { width, height, components, progressive: false, interleaved: true, restart_interval: 0, adobe_transform: None }
    }
}

impl Jpeg<'_> {
    pub fn write(&self, value: impl Fn(usize, usize, usize) -> u8) -> Vec<u8> {
        let mut file = vec![0xff, 0xd8];
        if let Some(transform) = self.adobe_transform {
            segment(&mut file, 0xee, &[b"Adobe".as_slice(), &[0, 100, 0, 0, 0, 0, transform]].concat());
        }
        // All steps 8: a DC difference of 1 is a difference of 1 in the block's value.
        segment(&mut file, 0xdb, &[&[0][..], &[8; 64]].concat());
        let [h1, h0] = self.height.to_be_bytes();
        let [w1, w0] = self.width.to_be_bytes();
        let mut frame = vec![8, h1, h0, w1, w0, self.components.len() as u8];
        frame.extend(self.components.iter().flat_map(|&(id, h, v)| [id, (h << 4 | v) as u8, 0]));
        segment(&mut file, if self.progressive { 0xc2 } else { 0xc0 }, &frame);
        // DC: the categories 0 to 11 have the codes 0000 to 1011. AC: the end of block has the code 0.
        segment(
            &mut file,
            0xc4,
            &[&[0x00, 0, 0, 0, 12, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0][..], &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]].concat(),
        );
        segment(&mut file, 0xc4, &[0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
        if self.restart_interval > 0 {
            segment(&mut file, 0xdd, &(self.restart_interval as u16).to_be_bytes());
        }
        let all: Vec<usize> = (0..self.components.len()).collect();
        let scans: Vec<Vec<usize>> = if self.interleaved { vec![all] } else { all.into_iter().map(|c| vec![c]).collect() };
        for scan in scans {
            self.scan(&mut file, &scan, &value);
        }
        file.extend([0xff, 0xd9]);
        file
    }

    fn scan(&self, file: &mut Vec<u8>, scan: &[usize], value: &impl Fn(usize, usize, usize) -> u8) {
        let mut header = vec![scan.len() as u8];
        header.extend(scan.iter().flat_map(|&c| [self.components[c].0, 0]));
        header.extend([0, if self.progressive { 0 } else { 63 }, 0]);
        segment(file, 0xda, &header);
        let mut bits = Bits::default();
        let mut previous = vec![128i32; self.components.len()];
        for (i, unit) in self.units(scan).into_iter().enumerate() {
            if self.restart_interval > 0 && i > 0 && i % self.restart_interval == 0 {
                bits.flush(file);
                file.extend([0xff, 0xd0 + ((i / self.restart_interval - 1) % 8) as u8]);
                previous.fill(128);
            }
            for (c, column, row) in unit {
                let next = i32::from(value(c, column, row));
                bits.dc(next - previous[c]);
                previous[c] = next;
                if !self.progressive {
                    bits.push(0, 1);
                }
            }
        }
        bits.flush(file);
    }

    /// The blocks of each minimum coded unit of a scan, in the order of the standard.
    fn units(&self, scan: &[usize]) -> Vec<Vec<(usize, usize, usize)>> {
        let [h_max, v_max] = [self.components.iter().map(|c| c.1).max().unwrap(), self.components.iter().map(|c| c.2).max().unwrap()];
        let (width, height) = (usize::from(self.width), usize::from(self.height));
        if let [c] = *scan {
            let (_, h, v) = self.components[c];
            let [columns, rows] = [(width * h).div_ceil(h_max).div_ceil(8), (height * v).div_ceil(v_max).div_ceil(8)];
            return (0..rows).flat_map(|row| (0..columns).map(move |column| vec![(c, column, row)])).collect();
        }
        let unit = |column: usize, row: usize| {
            let blocks = |&c: &usize| {
                let (_, h, v) = self.components[c];
                (0..v).flat_map(move |y| (0..h).map(move |x| (c, column * h + x, row * v + y)))
            };
            scan.iter().flat_map(blocks).collect()
        };
        let [columns, rows] = [width.div_ceil(8 * h_max), height.div_ceil(8 * v_max)];
        (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))).map(|(column, row)| unit(column, row)).collect()
    }
}

pub fn segment(file: &mut Vec<u8>, marker: u8, body: &[u8]) {
    file.extend([0xff, marker]);
    file.extend((body.len() as u16 + 2).to_be_bytes());
    file.extend(body);
}

#[derive(Default)]
struct Bits {
    bytes: Vec<u8>,
    pending: u32,
    count: u32,
}

impl Bits {
    fn dc(&mut self, difference: i32) {
        let category = 32 - difference.unsigned_abs().leading_zeros();
        self.push(category, 4);
        let low = if difference < 0 { difference - 1 } else { difference };
        self.push(low as u32 & ((1 << category) - 1), category);
    }

    fn push(&mut self, value: u32, count: u32) {
        for i in (0..count).rev() {
            self.pending = self.pending << 1 | (value >> i & 1);
            self.count += 1;
            if self.count == 8 {
                self.bytes.push(self.pending as u8);
                if self.pending as u8 == 0xff {
                    self.bytes.push(0);
                }
                (self.pending, self.count) = (0, 0);
            }
        }
    }

    /// Fills the last byte with ones and appends all to the file.
    fn flush(&mut self, file: &mut Vec<u8>) {
        while self.count > 0 {
            self.push(1, 1);
        }
        file.append(&mut self.bytes);
    }
}
