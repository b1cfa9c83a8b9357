-- How links are secured. Keys stand here only as AES-GCM made them (base64); the secret is not in the database.

CREATE TABLE link_security (
    drone_id        text PRIMARY KEY REFERENCES drone ON DELETE CASCADE,
    policy          text NOT NULL CHECK (policy IN ('OFF', 'OPTIONAL', 'REQUIRED')),
    sealed_key      text,
    sealed_next_key text,
    proven          boolean NOT NULL,
    stamp           bigint NOT NULL,
    CHECK (sealed_key IS NOT NULL OR (sealed_next_key IS NULL AND NOT proven))
);
