-- What is known of recordings; their bytes are files in the data directory.

-- No reference to drone: recordings outlive the drones that they show.
CREATE TABLE recording (
    id         text PRIMARY KEY,
    drone_id   text NOT NULL,
    drone_name text NOT NULL,
    started_at timestamptz NOT NULL,
    ended_at   timestamptz,
    bytes      bigint NOT NULL,
    frames     bigint NOT NULL,
    drops      bigint NOT NULL,
    state      text NOT NULL CHECK (state IN ('RUNNING', 'COMPLETE', 'INCOMPLETE')),
    notice     text
);

CREATE INDEX recording_of_drone ON recording (drone_id, started_at DESC);
