export type { RecordingView as Recording, RecordingPage } from './contract';
