// Measures the width available for a picture. A picture drawn at this width is not scaled, so that
// its texts keep their size.
import { useLayoutEffect, useRef, useState } from 'preact/hooks';

export function useWidth() {
  const ref = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(600);
  useLayoutEffect(() => {
    const place = ref.current;
    if (!place) return undefined;
    const measure = () => {
      if (place.clientWidth > 0) setWidth(place.clientWidth);
    };
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(place);
    return () => observer.disconnect();
  }, []);
  return { ref, width };
}
