export { Problem, sentenceFor } from '@dronemap/client';
