export type { WaitingView as WaitingVehicle } from '@dronemap/client';
