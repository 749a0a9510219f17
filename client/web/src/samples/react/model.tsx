import { useLoader, useThree } from '@react-three/fiber';
import { JsmLoader } from 'jsm-viewer';
import { useEffect } from 'react';
import type { PerspectiveCamera } from 'three';

/** A model that refines itself while a point may be off by more pixels. Its parent suspends until there is a first picture. */
export function Model({ url, pixels = 1 }: { url: string; pixels?: number }) {
  const model = useLoader(JsmLoader, url);
  const camera = useThree((state) => state.camera);
  const invalidate = useThree((state) => state.invalidate);

  useEffect(() => {
    const redraw = () => invalidate();
    model.addEventListener('change', redraw);
    model.setTargetError(pixels, camera as PerspectiveCamera);
    return () => {
      model.removeEventListener('change', redraw);
      model.setTargetError(null);
    };
  }, [model, pixels, camera, invalidate]);

  return <primitive object={model} />;
}
