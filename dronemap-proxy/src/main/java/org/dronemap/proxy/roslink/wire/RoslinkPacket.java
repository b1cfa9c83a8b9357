package org.dronemap.proxy.roslink.wire;

/** One message of a robot. */
public record RoslinkPacket(RoslinkHeader header, RobotMessage message) {}
