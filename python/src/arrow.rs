//! Tables as a stream of Arrow's C interface, which pandas, polars, pyarrow and others read. They
//! share the memory of the columns.
#![expect(
    unsafe_code,
    reason = "Arrow reads the memory of NumPy arrays; the arrays are kept as long as Arrow uses it"
)]

use crate::boundary::{Answer, Failure, answer};
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::Int8Type;
use arrow_array::{
    Array, ArrayRef, DictionaryArray, Float64Array, Int8Array, RecordBatch, RecordBatchIterator,
    StringArray,
};
use arrow_buffer::alloc::Allocation;
use arrow_buffer::{BooleanBuffer, Buffer, NullBuffer, ScalarBuffer};
use arrow_schema::{ArrowError, Field, Schema};
use numpy::{Element, PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;
use std::collections::HashMap;
use std::panic::AssertUnwindSafe;
use std::ptr::NonNull;
use std::sync::Arc;

/// An Arrow buffer that shares the memory of an array.
fn lent<T: Element + arrow_buffer::ArrowNativeType>(
    array: &Bound<'_, PyArray1<T>>,
) -> Answer<ScalarBuffer<T>> {
    let held = array.readonly();
    let values = held
        .as_slice()
        .map_err(|_| Failure::Input("a column of a table is not contiguous in memory".into()))?;
    let (bytes, length) = (NonNull::from(values).cast::<u8>(), size_of_val(values));
    let owner: Arc<dyn Allocation> = Arc::new(AssertUnwindSafe(array.clone().unbind()));
    // SAFETY: the bytes belong to the array, which `owner` keeps alive. longdrive.table makes the
    // arrays of a table read-only
    let buffer = unsafe { Buffer::from_custom_allocation(bytes, length, owner) };
    Ok(ScalarBuffer::from(buffer))
}

/// A column of numbers. NaN is a missing value.
fn numbers(array: &Bound<'_, PyArray1<f64>>) -> Answer<Float64Array> {
    let values = lent(array)?;
    let there = BooleanBuffer::collect_bool(values.len(), |row| !values[row].is_nan());
    let nulls = Some(NullBuffer::new(there)).filter(|nulls| nulls.null_count() > 0);
    Ok(Float64Array::new(values, nulls))
}

/// The capsule for `__arrow_c_stream__`. Each column has a name, numbers and a unit. `status`, if
/// given, becomes a column of words before column `at`: `names` has the word of each status number.
#[pyfunction]
pub fn arrow_stream<'py>(
    py: Python<'py>,
    columns: Vec<(String, Bound<'py, PyArray1<f64>>, String)>,
    status: Option<Bound<'py, PyArray1<i8>>>,
    names: Vec<String>,
    at: usize,
    metadata: HashMap<String, String>,
) -> PyResult<Bound<'py, PyCapsule>> {
    answer(|| {
        let refused = |error: ArrowError| Failure::Internal(format!("a table for Arrow: {error}"));
        let (mut fields, mut arrays): (Vec<Field>, Vec<ArrayRef>) = (vec![], vec![]);
        for (name, array, unit) in columns {
            let array = numbers(&array)?;
            let field = Field::new(name, array.data_type().clone(), true);
            fields.push(field.with_metadata(HashMap::from([("unit".to_owned(), unit)])));
            arrays.push(Arc::new(array));
        }
        if let Some(status) = status {
            let keys = Int8Array::new(lent(&status)?, None);
            let words = Arc::new(StringArray::from(names));
            let status = DictionaryArray::<Int8Type>::try_new(keys, words).map_err(refused)?;
            let at = at.min(fields.len());
            fields.insert(at, Field::new("status", status.data_type().clone(), false));
            arrays.insert(at, Arc::new(status));
        }
        let schema = Arc::new(Schema::new_with_metadata(fields, metadata));
        let batch = RecordBatch::try_new(Arc::clone(&schema), arrays).map_err(refused)?;
        let stream =
            FFI_ArrowArrayStream::new(Box::new(RecordBatchIterator::new([Ok(batch)], schema)));
        Ok(PyCapsule::new_with_value(
            py,
            stream,
            c"arrow_array_stream",
        )?)
    })
}
