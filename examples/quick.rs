use longdrive::*;
use longdrive::study::*;
fn main(){
  let mut worst=0; let mut n=0; let mut bad=0; let mut evals=0;
  let base = Setup::preset("mae494").unwrap();
  let mut s=0.123f64; let mut rnd=||{ s=(s*997.13+0.7131).fract(); s};
  let a: Vec<String> = std::env::args().collect();
  let (l0,l1,e0,e1,count)= if a.len()>4 {(a[1].parse::<f64>().unwrap(),a[2].parse::<f64>().unwrap(),a[3].parse::<f64>().unwrap(),a[4].parse::<f64>().unwrap(),a[5].parse::<usize>().unwrap())} else {(0.,20.,-10.,10.,1000)};
  let mut hist=std::collections::BTreeMap::new();
  for k in 0..count {
    let mut setup=base;
    setup.club.loft=(l0+(l1-l0)*rnd()).to_radians(); setup.swing.attack_angle=(e0+(e1-e0)*rnd()).to_radians(); if a.len()>7 {setup.club.loft=a[6].parse::<f64>().unwrap().to_radians(); setup.swing.attack_angle=a[7].parse::<f64>().unwrap().to_radians();}
    let (sl,se)=(setup.club.loft.to_degrees(),setup.swing.attack_angle.to_degrees());
    let flies=Drive::new(&setup).map(|d| d.landed().is_ok()).unwrap_or(false);
    let vary=vec![Vary::read(&setup,&format!("club.loft={l0}deg..{l1}deg")).unwrap(),Vary::read(&setup,&format!("swing.attack_angle={e0}deg..{e1}deg")).unwrap()];
    let search=Search{vary,..Search::longest_drive(&setup).unwrap()};
    let verbose=count<5;
    let o=optimum(&setup,search,move |i| if verbose {println!("  {} {:.9} {:?} kkt {:.1e} r {:.2e} {}",i.number,-i.value,i.x.iter().map(|v|v.to_degrees()).collect::<Vec<_>>(),i.kkt_residual,i.radius,i.kept)}).unwrap();
    let key=format!("{} {:?} loft {:.5} att {:.5}",o.status(),o.value().map(|v| (v*1e4).round()/1e4),o.solution.x[0].to_degrees(),o.solution.x[1].to_degrees());
    if (o.solution.x[1].to_degrees()-38.53223).abs()>2e-5 && count>5 {println!("MISS from {sl} {se}: {key} its {}",o.solution.iterations);}
    *hist.entry(key).or_insert(0)+=1;
    if flies { n+=1; worst=worst.max(o.solution.iterations); evals+=o.solution.evaluations; if o.status()!="converged"{bad+=1; if bad<3 {println!("start {} {} -> {} {}",setup.club.loft.to_degrees(),setup.swing.attack_angle.to_degrees(),o.solution.message,o.solution.iterations);} } if o.solution.iterations>15 && k%1==0 {println!("{} its from {} {}",o.solution.iterations,setup.club.loft.to_degrees(),setup.swing.attack_angle.to_degrees());} }
    if verbose {println!("{:?}",o.solution);}
  }
  println!("flying {n} worst its {worst} mean evals {} bad {bad}", evals as f64/n as f64);
  for (k,v) in hist {println!("{v:5} {k}");}
  let setup=Setup::preset("mae494").unwrap();
  let mk=||{let vary=vec![Vary::read(&setup,"club.loft=0deg..20deg").unwrap(),Vary::read(&setup,"swing.attack_angle=-10deg..10deg").unwrap()]; Search{vary,..Search::longest_drive(&setup).unwrap()}};
  let mut best=f64::MAX; for _ in 0..100 {let sr=mk(); let t=std::time::Instant::now(); let o=optimum(&setup,sr,|_|()).unwrap(); best=best.min(t.elapsed().as_secs_f64()); std::hint::black_box(o);} println!("optimum {:.3} ms",best*1e3);
}
