// The build copies three.js from its WebJar to this place; its types come from npm.
export * from 'three';
