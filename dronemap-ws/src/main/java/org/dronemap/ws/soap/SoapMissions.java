package org.dronemap.ws.soap;

/** What flies drones that its callers need not name one by one, and what was flown. */
public record SoapMissions(SoapPlans plans, SoapRuns runs, SoapVirtualDrones virtuals, SoapFlights flights) {}
