export type { WaitingView as WaitingVehicle } from './contract';
