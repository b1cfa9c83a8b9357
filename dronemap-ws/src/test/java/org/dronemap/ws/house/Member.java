package org.dronemap.ws.house;

/** A user of an organisation, and a key of theirs. */
public record Member(String name, String key, Http http) {}
