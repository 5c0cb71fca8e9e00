//! Why a job failed.

use crate::message::messages;
use serde::{Deserialize, Serialize};
use serde_json::Value;

messages! {
    /// Why a job of a run, or the reading of a file that it needs, failed.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Failure as "failure" {
        /// The host could not read the file, in its words.
        Unreadable { message: String },
        /// The job refused its input: [`crate::Error::code`], its text, [`crate::Error::is_usage`], and the JSON form of the error, by which it is said in
        /// any language. Without one, and where another build names it otherwise, its text is.
        Refused {
            code: String,
            message: String,
            usage: bool,
            #[serde(default)]
            #[cfg_attr(target_arch = "wasm32", tsify(type = "{ kind: string } | null", optional))]
            error: Option<Box<Value>>,
        },
        /// The worker broke down at a fault of the program.
        BrokeOff { message: String },
        /// The host or the module has not the memory that the job needs.
        OutOfMemory { message: String },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Error, Texts};

    #[test]
    fn what_a_job_refuses_is_said_in_any_language() {
        let error = Error::TooManyPixels { width: 60000, height: 60000, megapixels: 3600.0, max_megapixels: 400.0 };
        let failure = Failure::from(&error);
        let read: Failure = serde_json::from_str(&serde_json::to_string(&failure).unwrap()).unwrap();
        assert_eq!(read, failure);
        assert_eq!(Texts::english().text(&failure), error.to_string());
        assert_eq!(Texts::arabic().text(&failure), Texts::arabic().text(&error));
        assert_ne!(Texts::arabic().text(&failure), error.to_string());
    }

    #[test]
    fn an_error_that_no_catalogue_knows_is_said_by_its_text() {
        for error in ["", r#", "error": null"#, r#", "error": {"kind": "of_another_build"}"#] {
            let text = format!(r#"{{"kind": "refused", "code": "unreadable-image", "message": "no image", "usage": false{error}}}"#);
            let read: Failure = serde_json::from_str(&text).unwrap();
            assert_eq!(Texts::arabic().text(&read), "no image");
        }
    }
}
