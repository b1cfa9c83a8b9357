package org.dronemap.core.command;

/** Why a command or setpoint was refused: a code for programs and a sentence for people. */
public record Refusal(OutcomeCode code, String sentence) {}
