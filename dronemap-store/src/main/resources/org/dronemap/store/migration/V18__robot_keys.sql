-- What robots show of themselves. Only a hash (SHA-256, hexadecimal) of each key stands here; the drone may be one still to come.

CREATE TABLE robot_key (
    drone_id  text PRIMARY KEY,
    label     text NOT NULL,
    system_id integer NOT NULL CHECK (system_id BETWEEN 0 AND 65535),
    owner_id  text,
    key_hash  text NOT NULL UNIQUE,
    made_by   text NOT NULL,
    made_at   timestamptz NOT NULL
);
