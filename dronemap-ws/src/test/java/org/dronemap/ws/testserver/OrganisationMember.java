package org.dronemap.ws.testserver;

/** A user of an organisation, and a key of theirs. */
public record OrganisationMember(String name, String key, TestHttpClient http) {}
