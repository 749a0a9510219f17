import { Canvas } from '@react-three/fiber';
import { StrictMode, Suspense } from 'react';
import { createRoot } from 'react-dom/client';
import { Model } from './model.tsx';

const url = new URLSearchParams(location.search).get('model') ?? 'model.jsm';

createRoot(document.getElementById('root')!).render(
  <StrictMode>
    <Canvas frameloop="demand" camera={{ position: [0, 1, 3] }}>
      <hemisphereLight args={[0xffffff, 0x888888, 3]} />
      <Suspense fallback={null}>
        <Model url={url} />
      </Suspense>
    </Canvas>
  </StrictMode>,
);
