package org.dronemap.core.command;

/** Refusal of a command or setpoint: a code for programs and a sentence for people. */
public record Refusal(OutcomeCode code, String sentence) {}
