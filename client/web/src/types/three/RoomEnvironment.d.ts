export { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
