export type { RecordingView as Recording, RecordingPage } from '@dronemap/client';
