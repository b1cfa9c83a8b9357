-- The mode that a drone flew in by the will of the cloud: another one after a restart is somebody else's choice.
ALTER TABLE control_lease ADD COLUMN mode text;
