use longdrive::*;
fn main(){
  let setup = Setup::preset("mae494").unwrap();
  let wrt = ["club.loft", "swing.attack_angle"].map(|n| setup.variable(n).unwrap());
  let t = derivative::hessian(&setup, Outcome::Carry, &wrt).unwrap();
  println!("{:?}", t);
  let all = setup.variables();
  let time=|name:&str, f:&mut dyn FnMut()|{ let mut best=f64::MAX; for _ in 0..200 { let t=std::time::Instant::now(); for _ in 0..20 {f();} best=best.min(t.elapsed().as_secs_f64()/20.0);} println!("{name} {:.2} us", best*1e6); best};
  let v=time("value",&mut||{std::hint::black_box(Drive::new(std::hint::black_box(&setup)).unwrap());});
  let g=time("grad2",&mut||{std::hint::black_box(derivative::gradient(std::hint::black_box(&setup),Outcome::Carry,&wrt).unwrap());});
  let h=time("hess2",&mut||{std::hint::black_box(derivative::hessian(std::hint::black_box(&setup),Outcome::Carry,&wrt).unwrap());});
  let g12=time("grad12",&mut||{std::hint::black_box(derivative::gradient(std::hint::black_box(&setup),Outcome::Carry,&all[..12]).unwrap());});
  let ga=time("gradall",&mut||{std::hint::black_box(derivative::gradient(std::hint::black_box(&setup),Outcome::Carry,&all).unwrap());});
  println!("ratios {:.2} {:.2} {:.2} {:.2} n={}", g/v,h/v,g12/v,ga/v, all.len());
}
