-- What owners had set of what the cloud has changed on their drones, until it is put back.
-- No reference to drone: what could not be put back stays listed when the drone is removed.
CREATE TABLE owners_values (
    drone_id      text PRIMARY KEY,
    -- As it was called then.
    drone_name    text NOT NULL,
    since         timestamptz NOT NULL,
    return_meters float8,
    -- The cloud's own values are on board.
    written       boolean NOT NULL,
    -- Name, the owner's value, the cloud's, and the bits that a mission may change.
    body          json NOT NULL
);
