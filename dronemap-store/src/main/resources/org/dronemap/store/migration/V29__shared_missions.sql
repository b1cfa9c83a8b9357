-- Several drones may serve a virtual drone, each a share of its mission; each serves one virtual drone at a time.
CREATE TABLE virtual_drone_binding (
    drone         text PRIMARY KEY,
    virtual_drone text NOT NULL REFERENCES virtual_drone ON DELETE CASCADE,
    UNIQUE (drone, virtual_drone)
);

INSERT INTO virtual_drone_binding (drone, virtual_drone)
SELECT bound_drone, id FROM virtual_drone WHERE bound_drone IS NOT NULL;

ALTER TABLE virtual_drone DROP COLUMN bound_drone;
