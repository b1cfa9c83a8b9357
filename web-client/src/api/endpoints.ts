export type {
  DtlsKeyView as DtlsKey,
  EndpointView as Endpoint,
  RobotKeyRequest as NewRobotKey,
  RobotKeyView as RobotKey,
} from '@dronemap/client';
