use super::columnar::ColumnarFile;
use crate::external_errors::{DAMAGED, arrow_error_text, read_error_text};
use crate::input_file::InputFile;
use crate::units::counted;
use arrow_array::cast::AsArray;
use arrow_array::types::{Float32Type, Float64Type};
use arrow_array::{Array, RecordBatch, downcast_integer};
use arrow_buffer::Buffer;
use arrow_ipc::convert::try_fb_to_schema;
use arrow_ipc::reader::{RecordBatchDecoder, read_footer_length};
use arrow_ipc::{Endianness, Message, MessageHeader, root_as_footer, root_as_message};
use arrow_schema::{DataType, Schema};
use std::collections::HashMap;
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

const MAGIC: &[u8; 6] = b"ARROW1";
const FEATHER_1: &[u8; 4] = b"FEA1";
/// Continuation marker, which precedes the length of a message since Arrow 0.15.
const CONTINUATION: [u8; 4] = [0xff; 4];
/// Bytes after the footer: its length, and the magic number.
const TAIL: usize = 10;

/// Reads an Arrow IPC file or stream by record batches. The batches may be compressed with ZSTD or
/// LZ4. Feather version 2 is the same format. Lengths and offsets are checked against the file size
/// first, because arrow-ipc panics if they are wrong.
pub(super) struct ArrowFile {
    file: InputFile,
    schema: Arc<Schema>,
    /// Offset of the end of the messages: the end of a stream, or the footer of a file.
    end: u64,
    order: BatchOrder,
    /// Current record batch.
    batch: Option<RecordBatch>,
}

enum BatchOrder {
    /// A file lists the offsets of its record batches in the footer.
    Listed { starts: Vec<u64>, next: usize },
    /// In a stream the record batches follow one another, up to the end marker.
    Following { first: u64, next: u64 },
}

/// Header of a message, with the location of its body.
struct MessageHead {
    metadata: Vec<u8>,
    body: Range<u64>,
}

impl ColumnarFile for ArrowFile {
    fn open(path: &Path) -> Result<Self, String> {
        let unreadable = |error: std::io::Error| read_error_text(&error);
        let mut file = InputFile::open(path).map_err(unreadable)?;
        let length = file.size().map_err(unreadable)?;
        let mut magic = vec![];
        file.by_ref()
            .take(MAGIC.len() as u64)
            .read_to_end(&mut magic)
            .map_err(unreadable)?;
        if magic.is_empty() {
            return Err("it is empty".into());
        }
        if magic == MAGIC {
            return Self::of_file(file, length);
        }
        if magic.starts_with(FEATHER_1) {
            return Err(
                "it is a Feather file of version 1; write version 2, which is Arrow IPC".into(),
            );
        }
        Self::of_stream(file, length)
    }

    fn names(&self) -> Vec<String> {
        let fields = self.schema.fields().iter();
        fields.map(|field| field.name().clone()).collect()
    }

    fn refusal(&self, column: usize) -> Option<String> {
        let kind = self.schema.field(column).data_type();
        let is_read = kind.is_integer() || matches!(kind, DataType::Float32 | DataType::Float64);
        (!is_read).then(|| {
            format!("its type is {kind}; a column must hold numbers (float64, float32 or integers)")
        })
    }

    fn rewind(&mut self) {
        self.batch = None;
        match &mut self.order {
            BatchOrder::Listed { next, .. } => *next = 0,
            BatchOrder::Following { first, next } => *next = *first,
        }
    }

    fn next_piece(&mut self) -> Result<Option<usize>, String> {
        // free the old batch before reading the next
        self.batch = None;
        self.batch = self.next_batch()?;
        Ok(self.batch.as_ref().map(RecordBatch::num_rows))
    }

    fn values(&mut self, column: usize, rows: Range<usize>) -> Result<Vec<Option<f64>>, String> {
        let column = self
            .batch
            .as_ref()
            .map(|batch| batch.column(column).slice(rows.start, rows.len()));
        column
            .and_then(|column| numbers(&column))
            .ok_or("it is not a column of numbers".into())
    }
}

impl ArrowFile {
    fn of_file(mut file: InputFile, length: u64) -> Result<Self, String> {
        let cut_short = || {
            "it has no footer: it was cut short, or the program that wrote it did not close it"
                .to_owned()
        };
        let foot_end = length.checked_sub(TAIL as u64).ok_or_else(cut_short)?;
        let tail = bytes(&mut file, foot_end..length)?;
        let tail = tail.try_into().map_err(|_| cut_short())?;
        let foot = read_footer_length(tail)
            .ok()
            .and_then(|foot| foot_end.checked_sub(foot as u64));
        let end = foot.ok_or_else(cut_short)?;
        let foot = bytes(&mut file, end..foot_end)?;
        let foot =
            root_as_footer(&foot).map_err(|_| format!("its footer is damaged; {DAMAGED}"))?;
        let schema = read_schema(foot.schema())?;
        let starts = foot
            .recordBatches()
            .into_iter()
            .flatten()
            .map(|block| u64::try_from(block.offset()));
        let starts = starts
            .collect::<Result<_, _>>()
            .map_err(|_| "its footer is damaged (a record batch has a negative position)")?;
        Ok(Self {
            file,
            schema,
            end,
            order: BatchOrder::Listed { starts, next: 0 },
            batch: None,
        })
    }

    fn of_stream(file: InputFile, length: u64) -> Result<Self, String> {
        let schema = Arc::new(Schema::empty());
        let mut stream = Self {
            file,
            schema,
            end: length,
            order: BatchOrder::Following { first: 0, next: 0 },
            batch: None,
        };
        // a file would begin with its magic number, so this must be a stream, which begins with a
        // message
        let neither =
            "it is neither an Arrow IPC file nor a stream, or it was cut short in its first bytes";
        let head = stream.head(0).ok().flatten().ok_or(neither)?;
        let message = head.message(MessageHeader::Schema)?;
        stream.schema = read_schema(message.header_as_schema())?;
        stream.order = BatchOrder::Following {
            first: head.body.end,
            next: head.body.end,
        };
        Ok(stream)
    }

    /// The next record batch; `None` after the last.
    fn next_batch(&mut self) -> Result<Option<RecordBatch>, String> {
        let at = match &self.order {
            BatchOrder::Listed { starts, next } => match starts.get(*next) {
                Some(start) => *start,
                None => return Ok(None),
            },
            BatchOrder::Following { next, .. } => *next,
        };
        let Some(head) = self.head(at)? else {
            return match &self.order {
                BatchOrder::Listed { .. } => Err(
                    "its footer is damaged (there is no record batch at a listed position)".into(),
                ),
                BatchOrder::Following { .. } => Ok(None),
            };
        };
        match &mut self.order {
            BatchOrder::Listed { next, .. } => *next += 1,
            BatchOrder::Following { next, .. } => *next = head.body.end,
        }
        self.read(&head).map(Some)
    }

    fn read(&mut self, head: &MessageHead) -> Result<RecordBatch, String> {
        let message = head.message(MessageHeader::RecordBatch)?;
        let batch = message
            .header_as_record_batch()
            .ok_or("a record batch is damaged")?;
        if batch.length() < 0 {
            return Err(format!("a record batch claims {} rows", batch.length()));
        }
        let is_compressed = batch.compression().is_some();
        let body = Buffer::from_vec(bytes(&mut self.file, head.body.clone())?);
        for buffer in batch.buffers().into_iter().flatten() {
            let part = usize::try_from(buffer.offset())
                .ok()
                .zip(usize::try_from(buffer.length()).ok());
            let part =
                part.and_then(|(offset, length)| body.get(offset..offset.checked_add(length)?));
            let part =
                part.ok_or("a record batch is damaged (a column is longer than the batch)")?;
            if let (true, Some(length)) = (is_compressed, part.first_chunk()) {
                // the length −1 marks an uncompressed part
                let length = usize::try_from(i64::from_le_bytes(*length)).unwrap_or(0);
                let room = Vec::<u8>::new().try_reserve_exact(length);
                room.map_err(|_| {
                    format!(
                        "a column of a record batch claims {length} bytes, for which there is \
                             no memory"
                    )
                })?;
            }
        }
        let (schema, version) = (Arc::clone(&self.schema), message.version());
        RecordBatchDecoder::try_new(&body, batch, schema, &HashMap::new(), &version)
            .and_then(RecordBatchDecoder::read_record_batch)
            .map_err(|error| arrow_error_text(&error))
    }

    /// The header of the message at an offset; `None` at the end marker.
    fn head(&mut self, at: u64) -> Result<Option<MessageHead>, String> {
        let cut_short = || {
            "it ends too early: it was cut short, or the program that wrote it did not close it"
                .to_owned()
        };
        let mut word = |at: u64| -> Result<[u8; 4], String> {
            let end = at
                .checked_add(4)
                .filter(|end| *end <= self.end)
                .ok_or_else(cut_short)?;
            let mut word = [0; 4];
            word.copy_from_slice(&bytes(&mut self.file, at..end)?);
            Ok(word)
        };
        let (mut length, mut at) = (word(at)?, at + 4);
        if length == CONTINUATION {
            (length, at) = (word(at)?, at + 4);
        }
        let length = i32::from_le_bytes(length);
        if length == 0 {
            return match (&self.order, self.end - at) {
                (BatchOrder::Following { .. }, more @ 1..) => Err(format!(
                    "it has {} after its end; put each stream into a file of its own",
                    counted(more, "byte")
                )),
                _ => Ok(None),
            };
        }
        let length =
            u64::try_from(length).map_err(|_| format!("a message claims {length} bytes"))?;
        let body = at
            .checked_add(length)
            .filter(|body| *body <= self.end)
            .ok_or_else(cut_short)?;
        let metadata = bytes(&mut self.file, at..body)?;
        let message =
            root_as_message(&metadata).map_err(|_| format!("a message is damaged; {DAMAGED}"))?;
        let length = u64::try_from(message.bodyLength()).ok();
        let end = length
            .and_then(|length| body.checked_add(length))
            .filter(|end| *end <= self.end);
        let body = body..end.ok_or_else(cut_short)?;
        Ok(Some(MessageHead { metadata, body }))
    }
}

impl MessageHead {
    fn message(&self, wanted: MessageHeader) -> Result<Message<'_>, String> {
        let message = root_as_message(&self.metadata)
            .map_err(|_| format!("a message is damaged; {DAMAGED}"))?;
        match message.header_type() {
            kind if kind == wanted => Ok(message),
            kind => Err(format!(
                "a message is a {kind:?} where a {wanted:?} is expected"
            )),
        }
    }
}

/// Values of a numeric column; `None` for another type.
fn numbers(column: &dyn Array) -> Option<Vec<Option<f64>>> {
    macro_rules! read {
        ($kind:ty) => {
            Some(
                column
                    .as_primitive::<$kind>()
                    .iter()
                    .map(|value| value.map(|value| value as f64))
                    .collect(),
            )
        };
    }
    downcast_integer! {
        column.data_type() => (read),
        DataType::Float32 => read!(Float32Type),
        DataType::Float64 => read!(Float64Type),
        _ => None
    }
}

fn read_schema(schema: Option<arrow_ipc::Schema>) -> Result<Arc<Schema>, String> {
    let schema = schema.ok_or("it has no schema")?;
    if schema.endianness() != Endianness::Little {
        return Err("its numbers are big-endian; write it on a little-endian machine".into());
    }
    try_fb_to_schema(schema)
        .map(Arc::new)
        .map_err(|_| format!("its schema is damaged; {DAMAGED}"))
}

/// Reads a range that lies within the file.
fn bytes(file: &mut InputFile, part: Range<u64>) -> Result<Vec<u8>, String> {
    let length =
        usize::try_from(part.end - part.start).map_err(|_| "it is too large for this machine")?;
    let mut bytes = vec![0; length];
    file.seek(SeekFrom::Start(part.start))
        .and_then(|_| file.read_exact(&mut bytes))
        .map_err(|error| read_error_text(&error))?;
    Ok(bytes)
}
