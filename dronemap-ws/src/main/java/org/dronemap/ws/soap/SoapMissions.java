package org.dronemap.ws.soap;

/** What is not of one drone: what flies drones that its callers need not name one by one, what was flown, and keys of robots. */
public record SoapMissions(
        SoapPlans plans, SoapRuns runs, SoapVirtualDrones virtuals, SoapFlights flights, SoapRobotKeys robotKeys) {}
