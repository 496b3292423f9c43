//! Words of the hidden surfaces lecture.

use super::Key;

words! {}
