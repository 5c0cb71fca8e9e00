//! Operators of vectors, which are instructions of WebAssembly's SIMD and something plain elsewhere.

/// One operator, of both kinds of vectors; `$plain` is what it is without SIMD.
macro_rules! vector_operator {
    ($vector:ident, $name:ident, $method:ident, $simd:ident, |$a:ident, $b:ident| $plain:expr) => {
        impl std::ops::$name for $vector {
            type Output = Self;

            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($simd(self.0, other.0))
            }

            #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self.0, other.0);
                Self($plain)
            }
        }
    };
}
