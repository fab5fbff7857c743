//! The results of a batch, which threads compute in chunks.

use crate::boundary::{Answer, Failure};
use crate::hessians::Hessians;
use longdrive::batch::{Block, Status, StatusCounts};

/// Status number of a drive that landed, but lacks a requested outcome or derivative. It follows
/// the numbers of `longdrive::batch::Status`.
const UNDEFINED: i8 = Status::ALL.len() as i8;

/// The results of a batch or of one of its chunks, column after column.
pub struct Results {
    /// Number of allocated rows.
    pub room: usize,
    /// Number of computed rows.
    pub done: usize,
    /// Columns of `room` numbers each: first the points, then the outcomes, then the derivatives.
    pub columns: Vec<f64>,
    pub status: Vec<i8>,
    /// Hessians of the rows.
    pub hessians: Vec<f64>,
    pub status_counts: StatusCounts,
}

impl Results {
    /// The results of a chunk, with `width` outcomes and derivatives in each row.
    pub fn of_chunk(block: &Block, width: usize, hessians: Option<&Hessians>) -> Self {
        let rows = block.rows();
        let mut status: Vec<i8> = (0..rows).map(|row| block.status(row) as i8).collect();
        let of_point = if rows > 0 { block.point(0).len() } else { 0 };
        let mut points = Vec::with_capacity(rows * (of_point + width));
        for k in 0..of_point {
            points.extend((0..rows).map(|row| block.point(row)[k]));
        }
        let mut columns = Vec::with_capacity(rows * width);
        for column in 0..width {
            columns.extend(block.result(column).map(|value| value.unwrap_or(f64::NAN)));
        }
        let mut seconds = vec![];
        if let Some(hessians) = hessians {
            seconds.reserve(rows * hessians.width());
            for row in 0..rows {
                match hessians.of_row(block, row) {
                    Some(found) => seconds.extend(found),
                    None => seconds.extend(std::iter::repeat_n(f64::NAN, hessians.width())),
                }
            }
        }
        for (row, status) in status
            .iter_mut()
            .enumerate()
            .filter(|(_, status)| **status == Status::Landed as i8)
        {
            let of_row = hessians.map_or(0, Hessians::width);
            let mut numbers = columns
                .iter()
                .skip(row)
                .step_by(rows)
                .chain(seconds.iter().skip(row * of_row).take(of_row));
            if numbers.any(|number| number.is_nan()) {
                *status = UNDEFINED;
            }
        }
        let mut status_counts = StatusCounts::default();
        status_counts.add(block);
        points.append(&mut columns);
        Self {
            room: rows,
            done: rows,
            columns: points,
            status,
            hessians: seconds,
            status_counts,
        }
    }

    /// Allocates memory for `room` rows. Each row has `width` numbers in the columns and
    /// `of_hessians` second derivatives.
    pub fn new(room: usize, width: usize, of_hessians: usize) -> Answer<Self> {
        let numbers = room.checked_mul(width).zip(room.checked_mul(of_hessians));
        let has_room = |numbers: usize| Vec::<f64>::new().try_reserve_exact(numbers).is_ok();
        let Some((of_columns, of_hessians)) =
            numbers.filter(|(one, two)| has_room(one.saturating_add(*two)))
        else {
            let message = format!(
                "{room} drives with {} numbers each do not fit into memory; compute fewer at a \
                 time, or let the program write them to a file (longdrive sweep)",
                width + of_hessians
            );
            return Err(Failure::Input(message));
        };
        // the system allocates memory for zeros only when they are first accessed
        let (columns, hessians, status) =
            (vec![0.0; of_columns], vec![0.0; of_hessians], vec![0; room]);
        Ok(Self {
            room,
            done: 0,
            columns,
            status,
            hessians,
            status_counts: StatusCounts::default(),
        })
    }

    /// Appends the rows of a chunk.
    pub fn append(&mut self, chunk: &Self) {
        let rows = chunk.done;
        for (to, from) in self
            .columns
            .chunks_exact_mut(self.room.max(1))
            .zip(chunk.columns.chunks_exact(rows))
        {
            to[self.done..self.done + rows].copy_from_slice(from);
        }
        self.status[self.done..self.done + rows].copy_from_slice(&chunk.status);
        let width = chunk.hessians.len() / rows;
        self.hessians[self.done * width..(self.done + rows) * width]
            .copy_from_slice(&chunk.hessians);
        self.status_counts.merge(&chunk.status_counts);
        self.done += rows;
    }
}
