-- Areas of the cloud that drones stay in or out of; all of one is in its body, which its readers alone understand.

CREATE TABLE zone (
    id   text PRIMARY KEY,
    name text NOT NULL,
    body json NOT NULL
);
