//! Scenes that went wrong once, each the smallest that showed it.
