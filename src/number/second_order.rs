/// `each!(i: K => expression)`: an array of its values; `std::array::from_fn` is a call that the compiler does not always
/// take apart, and then the registers go through memory.
macro_rules! each {
    ($i:ident : $K:expr => $value:expr) => {{
        let mut all = [B::zero(); $K];
        let mut $i = 0;
        while $i < $K {
            all[$i] = $value;
            $i += 1;
        }
        all
    }};
}

/// The elementary functions of a number with second derivatives: f, f′ and f″ at its value, for its `chain` rule.
macro_rules! second_order_functions {
    () => {
        #[inline(always)]
        fn recip(self) -> Self {
            let f = self.re.recip();
            let square = f * f;
            self.chain(f, -square, square * f * 2.0)
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            let (f, inverse) = self.re.sqrt_recip();
            let slope = inverse * 0.5;
            self.chain(f, slope, -(slope * inverse * inverse * 0.5))
        }
        #[inline(always)]
        fn exp(self) -> Self {
            let f = self.re.exp();
            self.chain(f, f, f)
        }
        #[inline(always)]
        fn exp_m1(self) -> Self {
            let f = self.re.exp_m1();
            self.chain(f, f + 1.0, f + 1.0)
        }
        #[inline(always)]
        fn ln(self) -> Self {
            let slope = self.re.recip();
            self.chain(self.re.ln(), slope, -(slope * slope))
        }
        #[inline(always)]
        fn ln_1p(self) -> Self {
            let slope = (self.re + 1.0).recip();
            self.chain(self.re.ln_1p(), slope, -(slope * slope))
        }
        #[inline(always)]
        fn sin_cos(self) -> (Self, Self) {
            let (sin, cos) = self.re.sin_cos();
            (self.chain(sin, cos, -sin), self.chain(cos, -sin, -cos))
        }
        #[inline(always)]
        fn atan(self) -> Self {
            let slope = (self.re * self.re + 1.0).recip();
            self.chain(self.re.atan(), slope, self.re * slope * slope * -2.0)
        }
        #[inline(always)]
        fn tanh(self) -> Self {
            let f = self.re.tanh();
            let slope = -(f * f) + 1.0;
            self.chain(f, slope, f * slope * -2.0)
        }
    };
}
