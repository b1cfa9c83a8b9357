-- A holder was lost, and the drone is still to be called back.

ALTER TABLE control_lease ADD COLUMN lapsed boolean NOT NULL DEFAULT false;
