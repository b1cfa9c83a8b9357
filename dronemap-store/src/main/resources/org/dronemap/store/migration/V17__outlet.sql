-- What users attach their own ground stations with. Keys stand here only as AES-GCM made them (base64).

CREATE TABLE outlet_key (
    account    text PRIMARY KEY REFERENCES account ON DELETE CASCADE,
    sealed_key text NOT NULL,
    stamp      bigint NOT NULL
);

-- Under which system id a user's ground stations know a drone.
CREATE TABLE outlet_number (
    account   text NOT NULL REFERENCES account ON DELETE CASCADE,
    drone_id  text NOT NULL REFERENCES drone ON DELETE CASCADE,
    system_id integer NOT NULL CHECK (system_id BETWEEN 1 AND 255),
    PRIMARY KEY (account, drone_id),
    UNIQUE (account, system_id)
);
