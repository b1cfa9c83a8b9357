-- How each drone has shown who it is.

ALTER TABLE drone
    ADD COLUMN evidence text NOT NULL DEFAULT 'ADDRESS' CHECK (evidence IN ('ADDRESS', 'HARDWARE', 'SIGNATURE', 'LINK')),
    ADD COLUMN link_identity text UNIQUE,
    ADD COLUMN distinct_hardware boolean NOT NULL DEFAULT false;
