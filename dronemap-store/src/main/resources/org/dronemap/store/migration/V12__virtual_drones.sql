-- Virtual drones with what they do, which the readers of the body alone understand; and the drones that may serve them.

CREATE TABLE virtual_drone (
    id          text PRIMARY KEY,
    created_at  timestamptz NOT NULL,
    -- One drone serves one virtual drone at a time; null: none does.
    bound_drone text UNIQUE,
    body        json NOT NULL
);

CREATE TABLE warehouse_drone (
    drone_id text PRIMARY KEY REFERENCES drone ON DELETE CASCADE
);

-- Such a grant names no drone.
ALTER TABLE access_grant ADD COLUMN of_virtual_drones boolean NOT NULL DEFAULT false;
