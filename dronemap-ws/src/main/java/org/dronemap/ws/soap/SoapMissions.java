package org.dronemap.ws.soap;

/** What flies drones that its callers need not name one by one. */
public record SoapMissions(SoapPlans plans, SoapVirtualDrones virtuals) {}
